// Largest magnitudes the runtime computes with. Everything that stays within them stays finite (see
// lanes/sections_def.hpp).
#pragma once

namespace axisc::runtime {

/// Positions, inputs of self-tests and offsets of the origin: up to here whole units are exact.
inline constexpr double largest_position = 0x1p53;

/// |p| and |q| of a section.
inline constexpr double largest_numerator = 64;

/// |S| of a kernel.
inline constexpr double largest_tail = 64;

/// The largest increment that is rest where a switch needs standstill, just below a nanometre's millionth part.
inline constexpr double largest_increment_at_rest = 0x1.fffffffffffffp-31;

/// Factor from additive velocity to drive increments, and additive velocity itself.
inline constexpr double largest_scale = 0x1p100;
inline constexpr double largest_weight = 7;

/// The states of a section are together at most this large, and zero instead of smaller than this.
inline constexpr double largest_state = 0x1p200;
inline constexpr double smallest_state = 0x1p-500;

}  // namespace axisc::runtime
