// Letter case without the C locale.
#pragma once

#include "schema/words.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace axisc::schema {

constexpr char lower_case(char byte) {
  return byte >= 'A' && byte <= 'Z' ? static_cast<char>(byte - 'A' + 'a') : byte;
}

/// True if lower_case() changes nothing. Eight bytes at a time: every mistyped name is asked, and nearly all are lower case.
constexpr bool is_lower_case(std::string_view text) {
  constexpr std::uint64_t each_byte = 0x0101010101010101;
  constexpr std::uint64_t high_bits = 0x80 * each_byte;
  std::uint64_t capitals = 0;
  auto const look_at = [&capitals](std::uint64_t bytes) {
    // What is added carries into the high bit of a byte from 'A' on, or from behind 'Z' on, and never into the next byte.
    std::uint64_t const low = bytes & ~high_bits;
    capitals |= (low + (0x80 - 'A') * each_byte) & ~(low + (0x7F - 'Z') * each_byte) & ~bytes;
  };
  for (; text.size() >= 8; text.remove_prefix(8)) look_at(word_at(text.data()));
  look_at(word_of(text));
  return (capitals & high_bits) == 0;
}

/// Only A to Z change.
inline std::string lower_case(std::string_view text) {
  std::string folded(text);
  std::transform(folded.begin(), folded.end(), folded.begin(), [](char byte) { return lower_case(byte); });
  return folded;
}

}  // namespace axisc::schema
