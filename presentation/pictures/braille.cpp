#include "presentation/pictures/braille.hpp"

#include "presentation/pictures/projection.hpp"
#include "presentation/pictures/ticks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

namespace axisc::pictures {
namespace {

constexpr std::size_t dots_across = 2;
constexpr std::size_t dots_up = 4;
constexpr std::size_t margin = 10;
/// Letters are about twice as high as wide.
constexpr double height_of_letter = 2;

/// A canvas of dots, eight in a letter.
class Dots {
 public:
  Dots(std::size_t columns, std::size_t rows) : columns_(columns), rows_(rows), letters_(columns * rows, 0) {}

  [[nodiscard]] double width() const { return static_cast<double>(columns_ * dots_across) - 1; }
  [[nodiscard]] double height() const { return static_cast<double>(rows_ * dots_up) - 1; }

  void line(double x1, double y1, double x2, double y2) {
    auto const steps = static_cast<int>(std::ceil(std::max({std::abs(x2 - x1), std::abs(y2 - y1), 1.0})));
    for (int i = 0; i <= steps; ++i) {
      double const share = static_cast<double>(i) / steps;
      set(x1 + (x2 - x1) * share, y1 + (y2 - y1) * share);
    }
  }

  [[nodiscard]] std::string row(std::size_t row) const {
    std::string text;
    for (std::size_t column = 0; column < columns_; ++column) {
      // U+2800 and the bits of its dots.
      auto const code = 0x2800U + letters_[row * columns_ + column];
      text += static_cast<char>(0xE0U | (code >> 12U));
      text += static_cast<char>(0x80U | ((code >> 6U) & 0x3FU));
      text += static_cast<char>(0x80U | (code & 0x3FU));
    }
    return text;
  }

 private:
  void set(double x, double y) {
    auto const column = static_cast<std::size_t>(std::lround(std::clamp(x, 0.0, width())));
    auto const up = static_cast<std::size_t>(std::lround(std::clamp(y, 0.0, height())));
    constexpr unsigned bits[dots_up][dots_across] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
    auto& letter = letters_[up / dots_up * columns_ + column / dots_across];
    letter = static_cast<std::uint8_t>(letter | bits[up % dots_up][column % dots_across]);
  }

  std::size_t columns_, rows_;
  std::vector<std::uint8_t> letters_;
};

void draw(Dots& dots, Curve const& curve, Projection const& across, Projection const& up) {
  Point const* last = nullptr;
  for (Point const& point : curve.points) {
    if (std::isnan(point.y)) {
      last = nullptr;
      continue;
    }
    Point const& from = last != nullptr ? *last : point;
    dots.line(across(from.x), up(from.y), across(point.x), up(point.y));
    last = &point;
  }
}

std::string padded_left(std::string_view text, std::size_t width) {
  auto const letters = static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
  return std::string(letters < width ? width - letters : 0, ' ').append(text);
}

/// Three digits: the ends of an axis need no more.
std::string rounded_text(double value, Language language) {
  if (value == 0) return "0";
  double const step = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2);
  return number_text(std::round(value / step) * step, language);
}

std::string label_of(Axis const& axis) {
  return axis.unit.empty() ? axis.quantity : axis.quantity + " [" + axis.unit + "]";
}

std::string panel_text(Figure const& figure, Panel const& panel, std::size_t columns, Language language) {
  std::size_t const width = columns - margin;
  double const share = panel.height / (panel_right - panel_left);
  auto const rows = std::max<std::size_t>(
      3, static_cast<std::size_t>(std::lround(share * static_cast<double>(width) / height_of_letter)));
  Dots dots(width, rows);
  Projection const across(panel.x ? *panel.x : figure.x, 0, dots.width());
  Projection const up(panel.y, dots.height(), 0);
  for (Curve const& curve : panel.curves) draw(dots, curve, across, up);
  std::string text = panel.is_bare ? "" : std::string(margin, ' ') + label_of(panel.y) + "\n";
  // Names of bars are at their rows; otherwise the ends of the axis are.
  std::vector<std::string> margins(rows);
  auto const row_of = [&](double value) {
    return static_cast<std::size_t>(std::clamp(up(value), 0.0, dots.height())) / dots_up;
  };
  if (!panel.y.names.empty()) {
    for (std::size_t i = 0; i < panel.y.names.size(); ++i) {
      margins[row_of(panel.y.ticks[i])] = panel.y.names[i];
    }
  } else if (!panel.is_bare) {
    margins.front() = rounded_text(panel.y.high, language);
    margins.back() = rounded_text(panel.y.low, language);
    if (panel.y.low < 0 && panel.y.high > 0) margins[row_of(0)] = "0";
  }
  for (std::size_t row = 0; row < rows; ++row) {
    text += padded_left(margins[row], margin - 1) + " " + dots.row(row) + "\n";
  }
  return text;
}

std::string axis_text(Axis const& axis, std::size_t columns, Language language) {
  if (axis.quantity.empty()) return {};
  std::string const low = rounded_text(axis.low, language);
  std::string const high = rounded_text(axis.high, language) + " " + axis.unit;
  std::string const name = "  " + axis.quantity;
  std::size_t const used = margin + low.size() + name.size();
  return std::string(margin, ' ') + low + name + padded_left(high, columns > used ? columns - used : 0) +
         "\n";
}

}  // namespace

std::string braille(Figure const& figure, std::size_t columns, Language language) {
  std::string text = figure.title + "\n";
  if (figure.panels.empty()) return text + figure.nothing + "\n";
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    Panel const& panel = figure.panels[i];
    text += panel_text(figure, panel, columns, language);
    bool const is_last = i + 1 == figure.panels.size();
    if (is_last || panel.x || figure.panels[i + 1].x) {
      text += axis_text(panel.x ? *panel.x : figure.x, columns, language);
    }
  }
  return text;
}

}  // namespace axisc::pictures
