// 64 bytes of a list at a glance: which of them belong to a class, as one bit each, bit 0 for the first.
//
// A token's end is then found by counting zeros instead of looking at one byte after the other. With SSE2, which every
// 64-bit x86 has, four vectors make a block; elsewhere the class table does, one byte at a time.
#pragma once

#include "grammar/character_class.hpp"

#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace axisc::grammar {

struct TextBlock {
  static constexpr unsigned size = 64;

  std::uint64_t line_feed = 0;
  std::uint64_t blank = 0;    ///< space, tab
  std::uint64_t letter = 0;   ///< A..Z, a..z, underscore
  std::uint64_t digit = 0;    ///< 0..9
  std::uint64_t point = 0;    ///< .
  std::uint64_t opening = 0;  ///< [
  std::uint64_t closing = 0;  ///< ]
  std::uint64_t quote = 0;    ///< "
  std::uint64_t round = 0;    ///< (
  std::uint64_t unusual = 0;  ///< control characters but tab and line feed, and everything above 0x7E
};

#if defined(__SSE2__)

namespace detail {

class Vector {
 public:
  explicit Vector(char const* bytes)
      : bytes_(_mm_loadu_si128(reinterpret_cast<__m128i const*>(bytes))) {}  // NOLINT: how vectors are loaded

  [[nodiscard]] __m128i equal(char byte) const { return _mm_cmpeq_epi8(bytes_, _mm_set1_epi8(byte)); }
  /// `first` to `last`, both below 0x80.
  [[nodiscard]] __m128i between(char first, char last) const { return between(bytes_, first, last); }
  [[nodiscard]] __m128i letter() const {
    __m128i const folded = _mm_or_si128(bytes_, _mm_set1_epi8(0x20));
    return _mm_or_si128(between(folded, 'a', 'z'), equal('_'));
  }
  [[nodiscard]] __m128i blank() const { return _mm_or_si128(equal(' '), equal('\t')); }
  /// Bytes above 0x7F are negative here.
  [[nodiscard]] __m128i unusual() const {
    __m128i const low = _mm_cmplt_epi8(bytes_, _mm_set1_epi8(' '));
    __m128i const white = _mm_or_si128(equal('\t'), equal('\n'));
    return _mm_or_si128(_mm_andnot_si128(white, low), equal('\x7F'));
  }

 private:
  static __m128i between(__m128i bytes, char first, char last) {
    return _mm_and_si128(_mm_cmpgt_epi8(bytes, _mm_set1_epi8(static_cast<char>(first - 1))),
                         _mm_cmplt_epi8(bytes, _mm_set1_epi8(static_cast<char>(last + 1))));
  }

  __m128i bytes_;
};

inline std::uint64_t bits(__m128i vector, unsigned place) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(_mm_movemask_epi8(vector))) << place;
}

}  // namespace detail

/// Reads TextBlock::size bytes.
inline TextBlock look_at(char const* bytes) {
  TextBlock block;
  for (unsigned place = 0; place < TextBlock::size; place += 16) {
    detail::Vector const vector(bytes + place);
    block.line_feed |= detail::bits(vector.equal('\n'), place);
    block.blank |= detail::bits(vector.blank(), place);
    block.letter |= detail::bits(vector.letter(), place);
    block.digit |= detail::bits(vector.between('0', '9'), place);
    block.point |= detail::bits(vector.equal('.'), place);
    block.opening |= detail::bits(vector.equal('['), place);
    block.closing |= detail::bits(vector.equal(']'), place);
    block.quote |= detail::bits(vector.equal('"'), place);
    block.round |= detail::bits(vector.equal('('), place);
    block.unusual |= detail::bits(vector.unusual(), place);
  }
  return block;
}

#else

inline TextBlock look_at(char const* bytes) {
  TextBlock block;
  for (unsigned place = 0; place < TextBlock::size; ++place) {
    char const byte = bytes[place];
    std::uint64_t const bit = std::uint64_t{1} << place;
    if (is(character::letter, byte)) {
      block.letter |= bit;
    } else if (is(character::blank, byte)) {
      block.blank |= bit;
    } else if (is(character::digit, byte)) {
      block.digit |= bit;
    } else if (byte == '\n') {
      block.line_feed |= bit;
    } else if (is(character::control | character::high, byte)) {
      block.unusual |= bit;
    } else if (byte == '.') {
      block.point |= bit;
    } else if (byte == '[') {
      block.opening |= bit;
    } else if (byte == ']') {
      block.closing |= bit;
    } else if (byte == '"') {
      block.quote |= bit;
    } else if (byte == '(') {
      block.round |= bit;
    }
  }
  return block;
}

#endif

}  // namespace axisc::grammar
