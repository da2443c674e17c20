// Largest magnitudes the runtime computes with. Everything that stays within them stays finite (see
// section_kernel.hpp).
#pragma once

namespace axisc::runtime {

/// Positions, inputs of self-tests and offsets of the origin: up to here whole units are exact.
inline constexpr double largest_position = 0x1p53;

/// |p| and |q| of a section.
inline constexpr double largest_numerator = 64;

/// |S| of a kernel.
inline constexpr double largest_tail = 64;

/// Increments below this are rest where a switch needs standstill: a nanometre's millionth part.
inline constexpr double standstill_increment = 0x1p-30;

/// Factor from additive velocity to drive increments, and additive velocity itself.
inline constexpr double largest_scale = 0x1p100;
inline constexpr double largest_weight = 7;

/// A filter's state is at most this large, and zero instead of smaller than this.
inline constexpr double largest_state = 0x1p500;
inline constexpr double smallest_state = 0x1p-500;

}  // namespace axisc::runtime
