// Texts as words of eight bytes, to hash and compare names without going from byte to byte.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

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

/// word_at() for at most eight bytes, as if zeros followed them.
constexpr std::uint64_t word_of(std::string_view text) {
  std::array<char, sizeof(std::uint64_t)> bytes{};
  std::copy(text.begin(), text.end(), bytes.begin());
  return word_at(bytes.data());
}

/// Some bytes, at most eight, each of which changes the result.
[[gnu::always_inline]] constexpr std::uint64_t short_word(char const* bytes, std::size_t size) {
  if (std::is_constant_evaluated() || size < 4) {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < size; ++i) word = word << 8U | static_cast<unsigned char>(bytes[i]);
    return word;
  }
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  std::memcpy(&first, bytes, sizeof first);
  std::memcpy(&last, bytes + size - sizeof last, sizeof last);
  return std::uint64_t{first} << 32U | last;
}

#if defined(__SSE2__)
namespace detail {

/// Compares blocks of sixteen bytes; `size` is at least that.
[[gnu::always_inline]] inline bool same_vectors(char const* a, char const* b, std::size_t size) {
  auto const equal = [&](std::size_t at) {
    std::size_t const place = std::min(at, size - sizeof(__m128i));
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): how vectors are loaded
    __m128i const left = _mm_loadu_si128(reinterpret_cast<__m128i const*>(a + place));
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast)
    __m128i const right = _mm_loadu_si128(reinterpret_cast<__m128i const*>(b + place));
    return _mm_cmpeq_epi8(left, right);
  };
  __m128i all = _mm_and_si128(_mm_and_si128(equal(0), equal(16)), equal(32));
  for (std::size_t at = 48; at < size; at += sizeof(__m128i)) all = _mm_and_si128(all, equal(at));
  return _mm_movemask_epi8(all) == 0xFFFF;
}

}  // namespace detail
#endif

/// Whether `size` bytes are the same. From sixteen on they are compared sixteen at a time, and up to 48
/// without a loop: names are too short for a call to pay, and their length differs from line to line.
[[gnu::always_inline]] constexpr bool same_bytes(char const* a, char const* b, std::size_t size) {
  constexpr std::size_t step = 16;
  if (size < step) {
    if (size < 8) return short_word(a, size) == short_word(b, size);
    return ((word_at(a) ^ word_at(b)) | (word_at(a + size - 8) ^ word_at(b + size - 8))) == 0;
  }
#if defined(__SSE2__)
  if (!std::is_constant_evaluated()) return detail::same_vectors(a, b, size);
#endif
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

/// No capital letter of ASCII. Eight bytes at a time: every mistyped name is checked, and nearly all are
/// lower case.
constexpr bool is_lower_case(std::string_view text) {
  constexpr std::uint64_t each_byte = 0x0101010101010101;
  constexpr std::uint64_t high_bits = 0x80 * each_byte;
  std::uint64_t capitals = 0;
  auto const look_at = [&capitals](std::uint64_t bytes) {
    // The sum carries into the high bit of a byte from 'A' on, or from the character after 'Z' on, and never
    // into the next byte.
    std::uint64_t const low = bytes & ~high_bits;
    capitals |= (low + (0x80 - 'A') * each_byte) & ~(low + (0x7F - 'Z') * each_byte) & ~bytes;
  };
  for (; text.size() >= 8; text.remove_prefix(8)) look_at(word_at(text.data()));
  look_at(word_of(text));
  return (capitals & high_bits) == 0;
}

}  // namespace axisc::schema
