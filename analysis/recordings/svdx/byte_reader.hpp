// Little-endian numbers from bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace axisc::recordings {

/// The number at `offset`; `bytes` must have all of it.
template <class Number>
[[nodiscard]] Number number_at(std::string_view bytes, std::size_t offset) {
  using Bits = std::conditional_t<
      sizeof(Number) == 8, std::uint64_t,
      std::conditional_t<sizeof(Number) == 4, std::uint32_t,
                         std::conditional_t<sizeof(Number) == 2, std::uint16_t, std::uint8_t>>>;
  Bits bits = 0;
  for (std::size_t i = sizeof(Number); i-- > 0;) {
    auto const byte = static_cast<unsigned char>(bytes[offset + i]);
    if constexpr (sizeof(Number) > 1) bits = static_cast<Bits>(bits << 8U);
    bits = static_cast<Bits>(bits | byte);
  }
  Number number{};
  std::memcpy(&number, &bits, sizeof(number));
  return number;
}

}  // namespace axisc::recordings
