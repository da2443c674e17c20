// How fast a path may pass from one block to the next.
//
// With u0, u1 the directions before and behind, κ0, κ1 the curvatures, T = 1 cycle, for the modes of both
// blocks:
//     v |u1_i - u0_i| ≤ w_i a_i T          (corner; STEP: w = 1 and the stage at the axis' velocity)
//     v² |κ1_i - κ0_i| ≤ w'_i a_i          (where an arc begins or ends, P-CHAN-00009, not STEP)
#pragma once

#include "analysis/motion/path_block.hpp"

#include <cstddef>
#include <limits>

namespace axisc::motion {

struct JunctionLimit {
  double velocity = 0;  ///< units per cycle
  LimitedBy cause = LimitedBy::braking;
};

/// The lowest of both blocks' velocities and what the steps allow. A block that brakes late does not wait for
/// the feed of the next one.
[[nodiscard]] JunctionLimit junction_limit(PathBlock const& before, PathBlock const& after);

/// What the steps of the axes' velocities allow.
struct StepLimit {
  double velocity = std::numeric_limits<double>::infinity();  ///< units per cycle; infinite: any
  std::size_t axis = 0;                                       ///< of the path, whose step limits it
};
[[nodiscard]] StepLimit step_limit(PathBlock const& before, PathBlock const& after);
/// The velocity that steps allow, but no less than #TRANSVELMIN.
[[nodiscard]] double corner_velocity(PathBlock const& before, PathBlock const& after);
[[nodiscard]] double curvature_velocity(PathBlock const& before, PathBlock const& after);

}  // namespace axisc::motion
