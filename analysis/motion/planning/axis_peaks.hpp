// The largest acceleration and jerk of each axis along a path.
//
// On a straight line they are |u_i| a, |u_i| j. In the plane of an arc, with v, a, j along the path and ρ its
// radius of curvature, the vectors
//     a t + v²/ρ n,  (j - v³/ρ² share²) t + 3 v a/ρ n
// point anywhere while the arc turns: their lengths count for both axes.
#pragma once

#include "analysis/motion/path_block.hpp"
#include "analysis/motion/planning/phase.hpp"

namespace axisc::motion {

struct AxisPeaks {
  Point acceleration{};  ///< units per cycle²
  Point jerk{};          ///< units per cycle³
  bool jumps =
      false;  ///< the acceleration jumps within blocks or at their ends (STEP): the jerk has no bound

  void take(PathBlock const& block, Phase const& phase);
};

}  // namespace axisc::motion
