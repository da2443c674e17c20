// Questions about a double that are answered on its bits, so that no processor answers them by a branch.
#pragma once

#include <bit>
#include <stdint.h>

namespace axisc::runtime {

/// All bits set or none; what selections are made with.
using Mask = uint64_t;

[[nodiscard]] constexpr Mask mask_if(bool condition) {
  return 0U - static_cast<Mask>(condition);
}

[[nodiscard]] constexpr Mask select(Mask mask, Mask if_set, Mask if_clear) {
  return (if_set & mask) | (if_clear & ~mask);
}

[[nodiscard]] constexpr double select(Mask mask, double if_set, double if_clear) {
  return std::bit_cast<double>(
      select(mask, std::bit_cast<uint64_t>(if_set), std::bit_cast<uint64_t>(if_clear)));
}

/// Bits of |value|: ordered like |value|, infinity behind every number and NaN behind infinity.
[[nodiscard]] constexpr uint64_t magnitude_bits(double value) {
  return std::bit_cast<uint64_t>(value) & 0x7FFF'FFFF'FFFF'FFFFU;
}

[[nodiscard]] constexpr double magnitude(double value) {
  return std::bit_cast<double>(magnitude_bits(value));
}

[[nodiscard]] constexpr bool is_finite(double value) {
  return magnitude_bits(value) < 0x7FF0'0000'0000'0000U;
}

/// |value| <= limit; false for NaN. Expects 0 <= limit.
[[nodiscard]] constexpr bool is_within(double value, double limit) {
  return magnitude_bits(value) <= std::bit_cast<uint64_t>(limit);
}

}  // namespace axisc::runtime
