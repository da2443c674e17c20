// The vector from a point to the nearest point of a path that is known cycle by cycle.
#pragma once

#include "analysis/motion/point.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace axisc::motion {

struct NearestPoint {
  Point away{};  ///< from the given point to the path
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

/// A path in a plane, that of the first two components, whose nearest point is found without looking at all
/// of it: a way of s along the path leads at most s nearer.
class SearchedPath {
 public:
  explicit SearchedPath(std::vector<Point> points) : points_(std::move(points)) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      ways_.push_back(i == 0 ? 0 : ways_.back() + distance(points_[i], points_[i - 1]));
    }
  }

  [[nodiscard]] std::vector<Point> const& points() const { return points_; }
  /// Exact wherever the search begins; quick where the points next to `begin` are near.
  [[nodiscard]] NearestPoint nearest(Point const& point, std::size_t begin) const {
    NearestPoint found;
    std::size_t const last = points_.size() - 1;
    begin = std::min(begin, last);
    for (std::size_t i = begin; i < last;) {
      found.consider(point, points_[i], points_[i + 1], axes);
      double const spare = distance(points_[i + 1], point) - found.distance();
      auto const next = std::lower_bound(ways_.begin() + static_cast<std::ptrdiff_t>(i) + 1, ways_.end(),
                                         ways_[i + 1] + spare * safety);
      i = std::max(i + 1, static_cast<std::size_t>(next - ways_.begin()) - 1);
    }
    for (std::size_t i = begin; i > 0;) {
      found.consider(point, points_[i - 1], points_[i], axes);
      double const spare = distance(points_[i - 1], point) - found.distance();
      auto const next = std::upper_bound(ways_.begin(), ways_.begin() + static_cast<std::ptrdiff_t>(i),
                                         ways_[i - 1] - spare * safety);
      i = std::min(i - 1, static_cast<std::size_t>(next - ways_.begin()));
    }
    return found;
  }

 private:
  static constexpr std::size_t axes = 2;
  static constexpr double safety = 1 - 1e-9;  ///< against rounding of the sums

  static double distance(Point const& a, Point const& b) {
    double const x = a[0] - b[0];
    double const y = a[1] - b[1];
    return std::sqrt(x * x + y * y);
  }

  std::vector<Point> points_;
  std::vector<double> ways_;  ///< along the path up to each point
};

}  // namespace axisc::motion
