// Questions about a double that are answered on its bits, as masks for selections without a branch.
#pragma once

#include <bit>
#include <stdint.h>

namespace axisc::runtime {

/// All bits set or none.
using Mask = uint64_t;

inline constexpr Mask all_set = ~Mask{0};

/// The mask unchanged, but opaque to the compiler, which otherwise turns selections back into branches where
/// it thinks that one side is the usual one. Costs no instruction.
[[nodiscard]] inline Mask opaque(Mask mask) {
#if defined(__GNUC__)
  __asm__("" : "+r"(mask));
#endif
  return mask;
}

[[nodiscard]] inline Mask mask_if_less(uint64_t a, uint64_t b) {
  return opaque(0U - static_cast<Mask>(a < b));
}

[[nodiscard]] constexpr Mask select(Mask mask, Mask if_set, Mask if_clear) {
  return (if_set & mask) | (if_clear & ~mask);
}

[[nodiscard]] constexpr double select(Mask mask, double if_set, double if_clear) {
  return std::bit_cast<double>(
      select(mask, std::bit_cast<uint64_t>(if_set), std::bit_cast<uint64_t>(if_clear)));
}

/// The value or 0.
[[nodiscard]] constexpr double keep(Mask mask, double value) {
  return std::bit_cast<double>(mask & std::bit_cast<uint64_t>(value));
}

/// Bits of |value|: ordered like |value|, infinity after every number and NaN after infinity.
[[nodiscard]] constexpr uint64_t magnitude_bits(double value) {
  return std::bit_cast<uint64_t>(value) & 0x7FFF'FFFF'FFFF'FFFFU;
}

[[nodiscard]] constexpr double magnitude(double value) {
  return std::bit_cast<double>(magnitude_bits(value));
}

/// |value| <= limit; clear for NaN. Expects 0 <= limit.
[[nodiscard]] inline Mask mask_if_within(double value, double limit) {
  return ~mask_if_less(std::bit_cast<uint64_t>(limit), magnitude_bits(value));
}

[[nodiscard]] inline Mask mask_if_finite(double value) {
  return mask_if_less(magnitude_bits(value), 0x7FF0'0000'0000'0000U);
}

[[nodiscard]] inline bool is_within(double value, double limit) {
  return mask_if_within(value, limit) != 0;
}

[[nodiscard]] inline bool is_finite(double value) {
  return mask_if_finite(value) != 0;
}

/// The value, or 0 where it is below `limit`.
[[nodiscard]] inline double unless_below(double limit, double value) {
  return keep(~mask_if_less(magnitude_bits(value), std::bit_cast<uint64_t>(limit)), value);
}

/// The nearest multiple of 2^-53 times `unit`; numbers that are large compared with it are unchanged.
[[nodiscard]] constexpr double on_grid(double value, double unit) {
  return (value + unit) - unit;
}

}  // namespace axisc::runtime
