#include "axisc/answers/figures/polar_panel.hpp"

#include "presentation/pictures/projection.hpp"
#include "presentation/pictures/ticks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace axisc {

namespace {

constexpr double panel_height = 460;
/// In units of the drawn radius: how far the largest deviation is drawn from it.
constexpr double drawn_deviation = 0.3;
constexpr double outside = 1 + drawn_deviation * 1.1;
/// Where words lie beside a ring.
constexpr double words_height = 0.4;

}  // namespace

PolarPanel::PolarPanel(double radius, double largest)
    : radius_(radius),
      factor_(largest > 0 ? std::max(1.0, pictures::round_below(drawn_deviation * radius / largest)) : 1) {
  panel_.height = panel_height;
  panel_.is_bare = true;
}

void PolarPanel::add_ring(double deviation, std::string name, std::string words, Words place) {
  double const ring = shown(deviation);
  auto& curve = panel_.curves.emplace_back(
      pictures::Curve{.name = std::move(name), .role = pictures::Role::guide, .colour = 0, .points = {}});
  for (std::size_t i = 0; i <= polar_directions; ++i) {
    double const angle = 2 * std::numbers::pi * static_cast<double>(i) / polar_directions;
    curve.points.push_back({.x = ring * std::cos(angle), .y = ring * std::sin(angle)});
  }
  if (words.empty()) return;
  double const height = place == Words::below ? -words_height : words_height;
  panel_.labels.push_back({.at = {.x = outside + 0.05, .y = height}, .words = std::move(words)});
  // A line from the words to the ring.
  panel_.curves.push_back({.name = "",
                           .role = pictures::Role::guide,
                           .colour = 0,
                           .points = {{.x = std::sqrt(ring * ring - height * height), .y = height},
                                      {.x = outside + 0.02, .y = height}}});
}

void PolarPanel::add(pictures::Curve style, std::vector<pictures::Point> const& points) {
  for (auto const& point : points) {
    double const distance = std::hypot(point.x, point.y);
    double const scale = distance > 0 ? shown(distance - radius_) / distance : 0;
    style.points.push_back({.x = point.x * scale, .y = point.y * scale});
  }
  panel_.curves.push_back(std::move(style));
}

pictures::Panel PolarPanel::take() && {
  panel_.x = pictures::Axis{.low = -outside, .high = outside};
  panel_.y = {.low = -outside, .high = outside};
  pictures::make_equal(*panel_.x, panel_.y, panel_.height);
  return std::move(panel_);
}

}  // namespace axisc
