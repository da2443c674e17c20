// How far a filtered path is from a contour of lines and arcs, written down plainly, without any code of the
// folder under test; places between setpoints are looked at, too.
#pragma once

#include "plain_geometry.hpp"

#include <cstddef>
#include <vector>

namespace axisc::test {

/// A straight line, or an arc in the plane of two axes along which the third one moves evenly.
struct Leg {
  Place from{}, to{};
  bool is_arc = false;
  std::size_t first = 0, second = 1;
  double center_first = 0, center_second = 0;
  double sweep = 0;  ///< radians, counterclockwise above 0

  [[nodiscard]] Place at(double share) const;
};

struct Followed {
  double axis_error =
      0;  ///< largest component of the vectors from points of the contour to the nearest filtered ones
  std::size_t leg = 0;  ///< where, and at which share of it
  double share = 0;
  double off = 0;  ///< farthest setpoint from the contour
};

/// Cycles between a setpoint and what may belong to it in the filtered path: the chains' delay and reach. A
/// place that is passed twice has two neighbourhoods.
struct Neighbourhood {
  int first = 0, last = 0;
};

/// `setpoints` begin behind the beginning of the first leg, where the axes rest, and end on the last one;
/// `filtered` belong to the same cycles. All of them in one unit.
[[nodiscard]] Followed follow(std::vector<Leg> const& contour, std::vector<Place> const& setpoints,
                              std::vector<Place> const& filtered, Neighbourhood neighbourhood,
                              int points_between = 3);

}  // namespace axisc::test
