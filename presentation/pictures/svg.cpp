#include "presentation/pictures/svg.hpp"

#include "diagnostics/format_number.hpp"
#include "diagnostics/markup.hpp"
#include "presentation/pictures/projection.hpp"
#include "presentation/pictures/simplification.hpp"
#include "presentation/pictures/svg_text.hpp"
#include "presentation/pictures/text_width.hpp"
#include "presentation/pictures/ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace axisc::pictures {
namespace {

constexpr double text_size = 12;
constexpr double line_height = 17;
constexpr double gap_of_panels = 18;
constexpr std::size_t rows_of_marks = 3;
/// Digits of the ends of an axis: fewer than any two mathematics libraries share.
constexpr int scale_digits = 9;

/// Okabe and Ito: can be told apart by colour-blind readers. Without black and yellow, which would vanish in
/// one of the schemes.
constexpr std::array<std::string_view, 6> palette = {"#0072b2", "#d55e00", "#009e73",
                                                     "#cc79a7", "#e69f00", "#56b4e9"};
constexpr std::array<std::string_view, 6> dashes = {"", "7 3", "2 3", "9 3 2 3", "12 4", "4 2 1 2"};

std::string style() {
  std::string text =
      "<style>\n"
      ".paper{fill:#fff}.ink{fill:#222}.quiet{fill:#555}.edge{stroke:#888;fill:none}.grid{stroke:#e4e4e4}"
      ".mark{stroke:#999;stroke-dasharray:3 3}\n"
      ".curve{fill:none;stroke-linejoin:round}.whole{stroke-width:2.4}.part{stroke-width:1.2;opacity:.75}"
      ".before{stroke-width:1.2;stroke-dasharray:5 3}.guide{stroke:#888;stroke-width:1}.bar{stroke-width:14}"
      ".measured{stroke-width:1.5;stroke-dasharray:.1 4;"
      "stroke-linecap:round}\n";
  for (std::size_t i = 0; i < palette.size(); ++i) {
    text.append(".c").append(std::to_string(i)).append("{stroke:").append(palette[i]).append("}");
  }
  return text +
         "\n@media (prefers-color-scheme: dark){.paper{fill:#17191d}.ink{fill:#eee}.quiet{fill:#aaa}"
         ".grid{stroke:#33363c}.edge{stroke:#777}.guide{stroke:#999}}\n</style>\n";
}

std::string text_element(double x, double y, std::string_view words, std::string_view anchor = "start",
                         std::string_view kind = "ink") {
  std::string text = "<text";
  text += attribute("class", kind) + attribute("x", x) + attribute("y", y);
  if (anchor != "start") text += attribute("text-anchor", anchor);
  return text.append(">").append(escaped(words)).append("</text>\n");
}

std::string line_element(double x1, double y1, double x2, double y2, std::string_view kind) {
  return "<line" + attribute("class", kind) + attribute("x1", x1) + attribute("y1", y1) +
         attribute("x2", x2) + attribute("y2", y2) + "/>\n";
}

std::string axis_label(Axis const& axis) {
  return axis.unit.empty() ? axis.quantity : axis.quantity + " [" + axis.unit + "]";
}

class Writer {
 public:
  Writer(Figure const& figure, Language language) : figure_(figure), language_(language) {}

  std::string write() {
    y_ = 30;
    text_ += text_element(panel_left, y_ - 6, fitted(figure_.title, text_size, panel_right - panel_left));
    if (figure_.panels.empty()) {
      y_ += 2 * line_height;
      text_ += text_element(panel_left, y_, figure_.nothing, "start", "quiet");
      y_ += line_height;
    } else {
      write_marks();
      for (Panel const& panel : figure_.panels) write_panel(panel);
      write_legend();
    }
    if (figure_.shows_table) write_table();
    return head(y_ + 12) + text_ + "</svg>\n";
  }

 private:
  [[nodiscard]] std::string head(double height) const {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\"" +
           attribute("viewBox", "0 0 " + pixels(picture_width) + " " + pixels(height)) +
           R"( role="img" font-family="sans-serif")" + attribute("font-size", text_size) + ">\n<title>" +
           escaped(figure_.title) + "</title>\n<desc>" + escaped(figure_.description) + "</desc>\n" +
           style() + "<rect class=\"paper\"" + attribute("width", picture_width) +
           attribute("height", height) + "/>\n";
  }

  [[nodiscard]] Projection across() const { return {figure_.x, panel_left, panel_right}; }

  /// In rows above the panels; a mark whose label finds no place has its line alone.
  void write_marks() {
    std::vector<double> ends(rows_of_marks, panel_left - 1e3);
    std::vector<Mark> marks = figure_.marks;
    std::stable_sort(marks.begin(), marks.end(), [](Mark const& a, Mark const& b) { return a.at < b.at; });
    std::size_t used = 0;
    std::string labels;
    for (Mark const& mark : marks) {
      double const width = text_width(mark.label, text_size);
      double const x = std::clamp(across()(mark.at) - width / 2, panel_left, panel_right - width);
      auto const row = std::find_if(ends.begin(), ends.end(), [x](double end) { return end + 8 < x; });
      if (row == ends.end()) continue;
      *row = x + width;
      auto const number = static_cast<std::size_t>(row - ends.begin());
      used = std::max(used, number + 1);
      labels += text_element(x, y_ + line_height * (static_cast<double>(number) + 0.8), mark.label, "start",
                             "quiet");
    }
    text_ += labels;
    y_ += line_height * static_cast<double>(used) + 4;
  }

  void write_panel(Panel const& panel) {
    Panel const* const next = &panel == &figure_.panels.back() ? nullptr : &panel + 1;
    bool const has_numbers = !panel.is_bare && (next == nullptr || panel.x || next->x);
    double const top = y_;
    double const bottom = y_ + panel.height;
    Projection const up(panel.y, bottom, top);
    Projection const across(axis_of(panel), panel_left, panel_right);
    if (!panel.is_bare) {
      write_frame(panel, up, top, bottom, has_numbers);
      text_ += panel_begin(panel, top, bottom);
    }
    for (Curve const& curve : panel.curves) write_curve(curve, across, up);
    if (!panel.is_bare) text_ += "</g>\n";
    for (Label const& label : panel.labels) {
      text_ += text_element(across(label.at.x), up(label.at.y), label.words);
    }
    y_ = bottom + (panel.is_bare ? 0 : has_numbers ? 44 : gap_of_panels);
    if (has_numbers && next != nullptr) y_ += gap_of_panels - 6;
  }

  /// With its scales, from which places are read back into quantities.
  [[nodiscard]] std::string panel_begin(Panel const& panel, double top, double bottom) const {
    Axis const& x = axis_of(panel);
    bool const zooms = std::none_of(panel.curves.begin(), panel.curves.end(), [](Curve const& curve) {
      return curve.role == Role::bar || curve.role == Role::guide;
    });
    if (!zooms) return "<g>\n";
    return "<g class=\"panel\"" + attribute("data-x", scale_text(x, panel_left, panel_right)) +
           attribute("data-y", scale_text(panel.y, bottom, top)) + attribute("data-height", panel.height) +
           attribute("data-x-label", axis_label(x)) + attribute("data-y-label", axis_label(panel.y)) + ">\n";
  }

  [[nodiscard]] static std::string scale_text(Axis const& axis, double begin, double end) {
    return (axis.scale == Scale::logarithmic ? "logarithmic " : "linear ") +
           format_rounded(axis.low, scale_digits).written() + " " +
           format_rounded(axis.high, scale_digits).written() + " " + pixels(begin) + " " + pixels(end);
  }

  [[nodiscard]] Axis const& axis_of(Panel const& panel) const { return panel.x ? *panel.x : figure_.x; }

  /// Numbers that would run into the name of their axis.
  [[nodiscard]] bool needs_thousands(std::vector<double> const& ticks) const {
    constexpr double room = 44;
    return std::any_of(ticks.begin(), ticks.end(), [&](double tick) {
      return std::abs(tick) >= 1000 && text_width(number_text(tick, language_), text_size) > room;
    });
  }

  void write_frame(Panel const& panel, Projection const& up, double top, double bottom, bool has_numbers) {
    Axis const& x_axis = axis_of(panel);
    Projection const across(x_axis, panel_left, panel_right);
    constexpr std::size_t rows = 6;
    constexpr std::size_t columns = 12;
    auto const ticks = ticks_of(panel.y, rows);
    bool const in_thousands = needs_thousands(ticks);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      double const y = up(ticks[i]);
      text_ += line_element(panel_left, y, panel_right, y, "grid");
      text_ += text_element(panel_left - 6, y + 4,
                            panel.y.names.empty()
                                ? number_text(in_thousands ? ticks[i] / 1000 : ticks[i], language_)
                                : panel.y.names[i],
                            "end");
    }
    double end_of_label = -1e3;
    for (double const tick : ticks_of(x_axis, columns)) {
      double const x = across(tick);
      text_ += line_element(x, top, x, bottom, "grid");
      std::string const label = number_text(tick, language_);
      double const half = text_width(label, text_size) / 2;
      if (!has_numbers || x - half < end_of_label + 4 || x + half > picture_width) continue;
      text_ += text_element(x, bottom + 16, label, "middle");
      end_of_label = x + half;
    }
    for (Mark const& mark : figure_.marks) {
      if (panel.x) break;
      text_ += line_element(across(mark.at), top, across(mark.at), bottom, "mark");
    }
    text_ += "<rect class=\"edge\"" + attribute("x", panel_left) + attribute("y", top) +
             attribute("width", panel_right - panel_left) + attribute("height", panel.height) + "/>\n";
    if (panel.y.names.empty()) {
      Axis shown = panel.y;
      if (in_thousands) shown.unit = shown.unit.empty() ? "10³" : "10³ " + shown.unit;
      text_ += R"(<text class="ink" text-anchor="middle")" +
               attribute("transform", "translate(16 " + pixels((top + bottom) / 2) + ") rotate(-90)") + ">" +
               escaped(axis_label(shown)) + "</text>\n";
    }
    if (!has_numbers) return;
    text_ += text_element((panel_left + panel_right) / 2, bottom + 34, axis_label(x_axis), "middle");
  }

  void write_curve(Curve const& curve, Projection const& across, Projection const& up) {
    /// Together with the sampling's error far too small to be seen.
    constexpr double tolerance = 0.05;
    std::vector<Point> places;
    for (Point const& point : curve.points) places.push_back({.x = across(point.x), .y = up(point.y)});
    if (curve.role != Role::measured) places = simplified(places, tolerance);
    std::string path;
    bool open = false;
    std::string last;
    for (Point const& place : places) {
      if (std::isnan(place.y)) {
        open = false;
        continue;
      }
      std::string const text = pixels(place.x) + " " + pixels(place.y);
      if (open && text == last) continue;
      path += (open ? "L" : "M") + text;
      open = true;
      last = text;
    }
    if (path.empty()) return;
    text_ += "<path" + attribute("class", classes(curve)) + dash(curve) + attribute("d", path) + "><title>" +
             escaped(curve.name) + "</title></path>\n";
  }

  [[nodiscard]] static std::string classes(Curve const& curve) {
    constexpr std::array<std::string_view, 6> roles = {"whole", "part", "before", "measured", "guide", "bar"};
    std::string text = "curve ";
    text += roles[static_cast<std::size_t>(curve.role)];
    return curve.role == Role::guide ? text : text + " c" + std::to_string(curve.colour % palette.size());
  }

  /// Lines of one picture differ in print, too.
  [[nodiscard]] static std::string dash(Curve const& curve) {
    std::string_view const pattern = dashes[curve.colour % dashes.size()];
    bool const has_own = curve.role == Role::whole || curve.role == Role::part;
    return pattern.empty() || !has_own ? "" : attribute("stroke-dasharray", pattern);
  }

  /// Each name once, in the order of the panels.
  void write_legend() {
    std::vector<Curve const*> entries;
    for (Panel const& panel : figure_.panels) {
      for (Curve const& curve : panel.curves) {
        bool const is_new = std::none_of(entries.begin(), entries.end(),
                                         [&](Curve const* known) { return known->name == curve.name; });
        if (is_new && !curve.name.empty()) entries.push_back(&curve);
      }
    }
    std::stable_partition(entries.begin(), entries.end(),
                          [](Curve const* curve) { return curve->role == Role::whole; });
    constexpr double sample = 26;
    double x = panel_left;
    y_ += line_height;
    for (Curve const* const curve : entries) {
      double const width = sample + 8 + text_width(curve->name, text_size);
      if (x > panel_left && x + width > panel_right) {
        x = panel_left;
        y_ += line_height;
      }
      text_ += "<path" + attribute("class", classes(*curve)) + dash(*curve) +
               attribute("d", "M" + pixels(x) + " " + pixels(y_ - 4) + "L" + pixels(x + sample) + " " +
                                  pixels(y_ - 4)) +
               "/>\n";
      text_ += text_element(x + sample + 6, y_, curve->name);
      x += width + 18;
    }
  }

  /// Columns as wide as their longest cell.
  void write_table() {
    constexpr double gap = 18;
    std::vector<std::vector<std::string>> rows{figure_.table.header};
    rows.insert(rows.end(), figure_.table.rows.begin(), figure_.table.rows.end());
    std::vector<double> widths;
    for (auto const& row : rows) {
      widths.resize(std::max(widths.size(), row.size()), 0);
      for (std::size_t i = 0; i < row.size(); ++i) {
        widths[i] = std::max(widths[i], text_width(row[i], text_size));
      }
    }
    y_ += line_height;
    for (auto const& row : rows) {
      y_ += line_height;
      double x = panel_left;
      for (std::size_t i = 0; i < row.size(); ++i) {
        text_ += text_element(x, y_, row[i], "start", &row == &rows.front() ? "quiet" : "ink");
        x += widths[i] + gap;
      }
    }
  }

  Figure const& figure_;
  Language language_;
  std::string text_;
  double y_ = 0;
};

}  // namespace

std::string svg(Figure const& figure, Language language) {
  return Writer(figure, language).write();
}

}  // namespace axisc::pictures
