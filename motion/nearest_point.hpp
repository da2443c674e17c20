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

  /// Looks at the straight line from `a` to `b`, too; components from `axes` on are 0.
  void consider(Point const& point, Point const& a, Point const& b, std::size_t axes = most_axes) {
    double along = 0;
    double squared_length = 0;
    for (std::size_t i = 0; i < axes; ++i) {
      double const d = b[i] - a[i];
      along += d * (a[i] - point[i]);
      squared_length += d * d;
    }
    double const share = along < 0 ? std::min(1.0, -along / squared_length) : 0;
    Point vector{};
    double here = 0;
    for (std::size_t i = 0; i < axes; ++i) {
      // The end itself where it is nearest: exactly 0 for a point that the path passes.
      vector[i] = share < 1 ? (a[i] - point[i]) + share * (b[i] - a[i]) : b[i] - point[i];
      here += vector[i] * vector[i];
    }
    if (here >= squared) return;
    squared = here;
    away = vector;
  }
};

}  // namespace axisc::motion
