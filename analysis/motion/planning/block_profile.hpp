// One block, or a part of it, from one velocity to another: up to the highest velocity v with
//     s_up(v0, v) + s_down(v, v1) ≤ L,  v ≤ limit,
// along at v, and down.
//
// A block that begins above its limit, because braking began only with it, is first braked down to the limit.
#pragma once

#include "analysis/motion/planning/ramp.hpp"

#include <vector>

namespace axisc::motion {

/// Position units and cycles; `up` and `down` outlive it.
struct BlockTask {
  double length = 0;
  double velocity_in = 0, velocity_out = 0;
  double limit = 0;
  Ramp const* up = nullptr;
  Ramp const* down = nullptr;
};

/// The velocity along the middle of the block. One of both ramps alone fits into it.
[[nodiscard]] double middle_velocity(BlockTask const& task);
/// Appends the phases through that velocity. Their lengths add up to that of the block.
void append_profile(BlockTask const& task, double middle, std::vector<Phase>& phases);

}  // namespace axisc::motion
