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

/// The largest increment that counts as rest where a switch needs standstill, just below a millionth of a
/// nanometre.
inline constexpr double largest_increment_at_rest = 0x1.fffffffffffffp-31;

/// Factor from additive velocity to drive increments, and additive velocity itself.
inline constexpr double largest_scale = 0x1p100;
inline constexpr double largest_weight = 7;

// Limits that make subnormal numbers impossible in a cycle; lanes/sections_def.hpp explains why.

/// Positions and velocities below this are zero.
inline constexpr double smallest_position = 0x1p-500;

/// p of a section is zero below this, and its g, k and b, shares, weights and scales below the other.
inline constexpr double smallest_numerator = 0x1p-44;
inline constexpr double smallest_coefficient = 0x1p-62;

/// Tails of a kernel are zero below this, and the rest of 1 - s below the other.
inline constexpr double smallest_tail = 0x1p-128;
inline constexpr double smallest_rest = 0x1p-108;

/// Added and taken away again it leaves a multiple of 2^-620, and every number from 2^-513 on unchanged.
inline constexpr double grid = 0x1p-567;

/// r of a section is stored as r + grid: taking that away again costs one operation only.
inline constexpr double r_at_rest = grid;

/// Likewise for multiples of 2^-908.
inline constexpr double fine_grid = 0x1p-855;

/// The states of a section together are at most this large, and zero if smaller than this.
inline constexpr double largest_state = 0x1p200;
inline constexpr double smallest_state = 0x1p-500;

}  // namespace axisc::runtime
