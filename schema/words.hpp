// Texts as words of eight bytes: how names are hashed and compared without going from byte to byte.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace axisc::schema {

/// Eight bytes, the first one lowest, on every host.
constexpr std::uint64_t word_at(char const* bytes) {
  std::uint64_t word = 0;
  if (!std::is_constant_evaluated() && std::endian::native == std::endian::little) {
    std::memcpy(&word, bytes, sizeof word);
    return word;
  }
  for (std::size_t i = 0; i < sizeof word; ++i) {
    word |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  }
  return word;
}

/// The same of at most eight bytes, as if zeros stood behind them.
constexpr std::uint64_t word_of(std::string_view text) {
  std::array<char, sizeof(std::uint64_t)> bytes{};
  std::copy(text.begin(), text.end(), bytes.begin());
  return word_at(bytes.data());
}

/// Whether `size` bytes are the same. From sixteen on they are compared sixteen at a time, and up to 48 without a loop: names are
/// too short for a call to pay, and how long they are differs from line to line.
[[gnu::always_inline]] constexpr bool same_bytes(char const* a, char const* b, std::size_t size) {
  constexpr std::size_t step = 16;
  if (size < step) return std::equal(a, a + size, b);
  std::uint64_t difference = 0;
  auto const compare = [&](std::size_t at) {
    std::size_t const place = std::min(at, size - step);
    difference |= word_at(a + place) ^ word_at(b + place);
    difference |= word_at(a + place + 8) ^ word_at(b + place + 8);
  };
  compare(0);
  compare(step);
  compare(2 * step);
  for (std::size_t at = 3 * step; at < size; at += step) compare(at);
  return difference == 0;
}

constexpr bool same_bytes(std::string_view a, std::string_view b) {
  return a.size() == b.size() && same_bytes(a.data(), b.data(), a.size());
}

}  // namespace axisc::schema
