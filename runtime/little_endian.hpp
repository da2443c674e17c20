// Little-endian numbers from bytes at any address, on processors of either byte order.
#pragma once

#include <bit>
#include <stdint.h>

namespace axisc::runtime {

[[nodiscard]] constexpr uint16_t load_u16(uint8_t const* bytes) {
  return static_cast<uint16_t>(bytes[0] | (static_cast<uint32_t>(bytes[1]) << 8U));
}

[[nodiscard]] constexpr uint32_t load_u32(uint8_t const* bytes) {
  return load_u16(bytes) | (static_cast<uint32_t>(load_u16(bytes + 2)) << 16U);
}

[[nodiscard]] constexpr uint64_t load_u64(uint8_t const* bytes) {
  return load_u32(bytes) | (static_cast<uint64_t>(load_u32(bytes + 4)) << 32U);
}

/// IEEE 754 binary64.
[[nodiscard]] constexpr double load_f64(uint8_t const* bytes) {
  return std::bit_cast<double>(load_u64(bytes));
}

}  // namespace axisc::runtime
