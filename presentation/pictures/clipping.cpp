#include "presentation/pictures/clipping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace axisc::pictures {
namespace {

/// Liang and Barsky: the share of the way from a to b that is inside, if any.
std::optional<std::pair<double, double>> inside(Point const& a, Point const& b, Axis const& x,
                                                Axis const& y) {
  double enter = 0;
  double leave = 1;
  auto const cut = [&](double from, double way, double low, double high) {
    if (way == 0) return from >= low && from <= high;
    double const first = (low - from) / way;
    double const second = (high - from) / way;
    enter = std::max(enter, std::min(first, second));
    leave = std::min(leave, std::max(first, second));
    return enter <= leave;
  };
  if (!cut(a.x, b.x - a.x, x.low, x.high) || !cut(a.y, b.y - a.y, y.low, y.high)) return std::nullopt;
  return std::pair(enter, leave);
}

}  // namespace

std::vector<Point> clipped(std::vector<Point> const& points, Axis const& x, Axis const& y) {
  std::vector<Point> result;
  bool continues = false;
  for (std::size_t i = 1; i < points.size(); ++i) {
    Point const& a = points[i - 1];
    Point const& b = points[i];
    bool const is_drawn =
        std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(b.x) && std::isfinite(b.y);
    auto const shares = is_drawn ? inside(a, b, x, y) : std::nullopt;
    if (!shares) {
      continues = false;
      continue;
    }
    auto const at = [&](double share) {
      return Point{.x = a.x + (b.x - a.x) * share, .y = a.y + (b.y - a.y) * share};
    };
    if (!continues || shares->first > 0) {
      if (!result.empty()) result.push_back({.x = a.x, .y = std::numeric_limits<double>::quiet_NaN()});
      result.push_back(at(shares->first));
    }
    result.push_back(at(shares->second));
    continues = shares->second >= 1;
  }
  return result;
}

}  // namespace axisc::pictures
