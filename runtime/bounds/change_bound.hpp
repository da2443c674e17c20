// B7: what changes of kernels in motion add.
#pragma once

#include "runtime/verification/image_view.hpp"

#include <stdint.h>

namespace axisc::runtime::bounds {

/// The most that a fade of an axis adds within P-AXIS-00212 and P-AXIS-00008, v and a per cycle, as shares of
/// them, and the cycles of that fade. With g the gain of the other filters and L = g sum of |S_A - S_B|, a
/// fade of F cycles adds at most
///     15/(8 F) L v   to |y[n] - y[n-1]|,   10/(sqrt(3) F^2) L v + 15/(4 F) L a   to its change.
/// All 0 where no change happens in motion.
struct ChangeBound {
  double velocity, acceleration;
  uint32_t cycles;
};

/// Of what the header of axisrt_command states, with what rounding adds to a fade that just fulfils it.
inline constexpr double largest_change = 0.25 * (1 + 0x1p-30);

/// A is any kernel that the slot can execute, B what a command changes to. `gain`: gain_high of the chain
/// without a kernel. Cost: for each pair the tails of both.
[[nodiscard]] ChangeBound bound_changes(ImageView const& view, uint32_t axis, double gain);

}  // namespace axisc::runtime::bounds
