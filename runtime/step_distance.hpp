// How far a chain moves a setpoint, computed from its stored coefficients.
#pragma once

#include "runtime/runtime_object.hpp"

#include <stdint.h>

namespace axisc::runtime {

/// Bounds for the chain of a line, with whichever kernel its slot works. With the step response s,
///     |y - x| <= sum of |s - 1| times the largest increment.
struct StepDistance {
  /// False for a chain that does not pass the constant part unchanged, or that does not settle.
  bool is_bounded;
  double sum;         ///< of |s[n] - 1|
  double peak_gain;   ///< sum of |h[n]|
  uint32_t settling;  ///< cycles after which |s - 1| stays below 2^-20
};

/// Computes the step response: at most 2^21 cycles. Not in the cycle.
[[nodiscard]] StepDistance step_distance(axisrt const& runtime, LinePort const& port, uint32_t index);

/// The largest distance in cycles between the chain's answer to a ramp of one unit per cycle and the ramp
/// itself, later by the group delay at 0 Hz. False for a chain that does not follow a ramp. Computes the step
/// response twice.
[[nodiscard]] bool corner_error(axisrt const& runtime, LinePort const& port, uint32_t index, double& cycles);

}  // namespace axisc::runtime
