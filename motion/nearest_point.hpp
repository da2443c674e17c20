// The vector from a point to the nearest point of a path that is known cycle by cycle.
#pragma once

#include "motion/point.hpp"

#include <algorithm>
#include <limits>

namespace axisc::motion {

struct NearestPoint {
  Point away{};  ///< from the point that was asked for to the path
  double squared = std::numeric_limits<double>::infinity();

  [[nodiscard]] double distance() const { return std::sqrt(squared); }

  /// Looks at the straight line from `a` to `b`, too.
  void consider(Point const& point, Point const& a, Point const& b) {
    Point const from_a = minus(a, point);
    Point const along = minus(b, a);
    double const squared_length = dot(along, along);
    double const share =
        squared_length > 0 ? std::clamp(-dot(from_a, along) / squared_length, 0.0, 1.0) : 0.0;
    Point const vector = plus(from_a, share, along);
    double const here = dot(vector, vector);
    if (here >= squared) return;
    squared = here;
    away = vector;
  }
};

}  // namespace axisc::motion
