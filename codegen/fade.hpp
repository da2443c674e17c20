// How long a change from one kernel to another must take, so that it does not jerk the axis.
#pragma once

#include "design/kernels/kernel_design.hpp"
#include "design/units.hpp"

#include <cstdint>

namespace axisc::codegen {

/// The limits of an axis, in position units and NC cycles.
struct MotionLimits {
  double velocity = 0;      ///< units per cycle
  double acceleration = 0;  ///< units per cycle and cycle
};

/// From P-AXIS-00212 (µm/s or 1e-3 °/s) and P-AXIS-00008 (mm/s² or °/s²) to units of 0.1 µm or 1e-4 °.
[[nodiscard]] MotionLimits motion_limits(double velocity_limit, double acceleration_limit,
                                         design::CycleTime cycle_time);

/// Longest fade; where a longer one would be needed, kernels change at standstill only.
inline constexpr std::uint32_t longest_fade = 4096;

/// The fewest cycles F after which the fade  A + w (B - A), w = t³ (10 - 15 t + 6 t²), adds at most 25 % of
/// the velocity limit v and 25 % of the acceleration limit a. `distance` is L = g Σ|S_A - S_B|, g the peak
/// gain of the other filters of the axis, so that |B - A| <= L v and its change in a cycle <= L a:
///     15/(8 F) L v <= v/4,   10/(√3 F²) L v + 15/(4 F) L a <= a/4
/// 0 where that takes more than longest_fade cycles, or a limit is 0; at least 1.
[[nodiscard]] std::uint32_t fade_cycles(double distance, MotionLimits const& limits);

/// Σ|S_A - S_B|; null for the signal that passes unchanged.
[[nodiscard]] double tail_distance(design::KernelDesign const* a, design::KernelDesign const* b);

}  // namespace axisc::codegen
