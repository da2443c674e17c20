// The geometry of one block: a straight line, or an arc that may rise along other axes (a helix).
#pragma once

#include "analysis/motion/point.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace axisc::motion {

/// An arc in the plane of two axes, evaluated exactly wherever it is asked for.
struct Arc {
  std::size_t first = 0,
              second = 1;  ///< axes of the plane; counterclockwise turns the first towards the second
  double center_first = 0, center_second = 0;  ///< position units
  double radius = 0;
  double phase = 0;   ///< of the beginning, radians
  double sweep = 0;   ///< radians; negative clockwise
  double length = 0;  ///< along the path, other axes included
  double share = 1;   ///< of the way that lies in the plane: r |sweep| / length

  /// r / share²: how strongly the path bends.
  [[nodiscard]] double curvature_radius() const { return radius / (share * share); }
};

class Segment {
 public:
  Segment() = default;
  /// Along a unit vector.
  Segment(Point const& begin, Point const& direction) : begin_(begin), direction_(direction) {}
  /// Axes outside of the arc's plane move along `direction`.
  Segment(Point const& begin, Point const& direction, std::shared_ptr<Arc const> arc)
      : begin_(begin), direction_(direction), arc_(std::move(arc)) {}

  [[nodiscard]] Arc const* arc() const { return arc_.get(); }
  [[nodiscard]] Point const& begin() const { return begin_; }
  /// The point this far along the path.
  [[nodiscard]] Point at(double way) const {
    Point point = plus(begin_, way, direction_);
    if (!arc_) return point;
    double const angle = arc_->phase + arc_->sweep * (way / arc_->length);
    point[arc_->first] = arc_->center_first + arc_->radius * std::cos(angle);
    point[arc_->second] = arc_->center_second + arc_->radius * std::sin(angle);
    return point;
  }
  /// The unit vector there.
  [[nodiscard]] Point direction_at(double way) const {
    if (!arc_) return direction_;
    Point direction = direction_;
    double const angle = arc_->phase + arc_->sweep * (way / arc_->length);
    double const turn = arc_->sweep < 0 ? -arc_->share : arc_->share;
    direction[arc_->first] = -turn * std::sin(angle);
    direction[arc_->second] = turn * std::cos(angle);
    return direction;
  }

 private:
  Point begin_{}, direction_{};
  std::shared_ptr<Arc const> arc_;
};

}  // namespace axisc::motion
