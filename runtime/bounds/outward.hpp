// Bounds are stored with 40 significant bits, rounded away from what they bound, and 2^-41 of their value
// beyond it: correct computations may differ in their last bits and still agree.
#pragma once

#include "runtime/double_bits.hpp"

#include <bit>
#include <stdint.h>

namespace axisc::runtime::bounds {

inline constexpr double unit_roundoff = 0x1p-53;
/// Factor for roundings of roundings, and for sums of up to 2^22 terms.
inline constexpr double second_order = 1 + 0x1p-20;

inline constexpr uint64_t dropped_bits = 0x1FFF;  ///< the last 13 of 53

/// The least number of 40 bits that is not below `value`, which is 0 or above.
[[nodiscard]] constexpr double up_to_40_bits(double value) {
  return std::bit_cast<double>((std::bit_cast<uint64_t>(value) + dropped_bits) & ~dropped_bits);
}

/// An upper bound of a value that is computed with `error` at most; the value itself where nothing was
/// rounded. What is not a number stays that: nothing is claimed then, and loaders refuse it.
[[nodiscard]] constexpr double above(double value, double error) {
  if (error == 0) return up_to_40_bits(value);
  double const bound = value + error;
  return bound <= 0 ? 0 : up_to_40_bits(bound * (1 + 0x1p-41));
}

/// A lower bound, 0 at least.
[[nodiscard]] constexpr double below(double value, double error) {
  double const bound = error == 0 ? value : (value - error) * (1 - 0x1p-41);
  return bound > 0 ? std::bit_cast<double>(std::bit_cast<uint64_t>(bound) & ~dropped_bits) : 0;
}

[[nodiscard]] constexpr double larger(double a, double b) {
  return a > b ? a : b;
}

}  // namespace axisc::runtime::bounds
