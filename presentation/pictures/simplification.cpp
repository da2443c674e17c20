#include "presentation/pictures/simplification.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axisc::pictures {
namespace {

bool rises(std::vector<Point> const& points) {
  return std::adjacent_find(points.begin(), points.end(), [](Point const& a, Point const& b) {
           return std::isfinite(a.y) && std::isfinite(b.y) && !(a.x < b.x);
         }) == points.end();
}

}  // namespace

std::vector<Point> simplified(std::vector<Point> const& points, double tolerance) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (points.size() < 3 || !rises(points)) return points;
  std::vector<Point> result;
  // Lines from the last kept point pass closely enough by all points left out since, if their slope is
  // between these.
  double lowest = -infinity;
  double highest = infinity;
  Point const* left_out = nullptr;
  auto const keep = [&](Point const& point) {
    result.push_back(point);
    left_out = nullptr;
    lowest = -infinity;
    highest = infinity;
  };
  for (Point const& point : points) {
    bool const interrupts = !std::isfinite(point.y);
    if (interrupts || result.empty() || !std::isfinite(result.back().y)) {
      if (interrupts && left_out != nullptr) keep(*left_out);
      keep(point);
      continue;
    }
    auto const slope = [&](double y) { return (y - result.back().y) / (point.x - result.back().x); };
    if (left_out != nullptr && !(slope(point.y) >= lowest && slope(point.y) <= highest)) keep(*left_out);
    lowest = std::max(lowest, slope(point.y - tolerance));
    highest = std::min(highest, slope(point.y + tolerance));
    left_out = &point;
  }
  if (left_out != nullptr) keep(*left_out);
  return result;
}

}  // namespace axisc::pictures
