// Names, numbers and trailers, judged by the bits of their block.
#pragma once

#include "grammar/axis_list.hpp"
#include "grammar/levels/text_block_def.hpp"

#include <cstdint>
#include <cstring>

/// Classes that several functions ask for are computed once where all is one function.
#define AXISC_INLINE inline __attribute__((always_inline))

namespace axisc::grammar::AXISC_LEVEL {

/// The place of the lowest bit, and the one behind the highest. There is one; first_or_last_of() gives 63 without.
inline unsigned first_of(Bits bits) {
  return static_cast<unsigned>(__builtin_ctzll(bits));
}
inline unsigned first_or_last_of(Bits bits) {
  return first_of(bits | Bits{1} << 63U);
}
inline unsigned end_of(Bits bits) {
  return 64U - static_cast<unsigned>(__builtin_clzll(bits));
}
inline Bits lowest(Bits bits) {
  return bits & (0 - bits);
}
/// The unbroken run that begins with the lowest bit: an addition carries through it.
inline Bits first_run(Bits bits) {
  return bits & ~(bits + lowest(bits));
}

/// Zero if the run `name` is a name. Begins and points are followed by letters. Brackets are filled with digits and
/// followed by a point or nothing: of well-formed pairs the difference covers every opening bracket and what stands behind
/// it up to the closing one.
AXISC_INLINE Bits wrong_in_name(TextBlock const& block, Bits name) {
  Bits const letter = block.letter() & name;
  Bits const digit = block.digit() & name;
  Bits const point = block.point() & name;
  Bits const opening = block.opening() & name;
  Bits const closing = block.closing() & name;
  Bits const identifier = letter | digit;
  Bits const inside = closing - opening;
  Bits const needs_letter = lowest(name) | (point << 1U);
  Bits const needs_digit = (inside & ~opening) | (opening << 1U);
  Bits const needs_identifier = opening >> 1U;
  Bits const needs_point = (closing << 1U) & name;
  return (name & ~(identifier | point | opening | closing)) | (needs_letter & ~letter) |
         (needs_digit & ~digit) | (needs_identifier & ~identifier) | (needs_point & ~point) |
         (opening & ~inside);
}

/// `Ende` in any letter case.
inline bool is_end_marker(char const* name, unsigned size) {
  std::uint32_t word = 0;
  std::uint32_t marker = 0;
  std::memcpy(&word, name, sizeof word);
  std::memcpy(&marker, "ende", sizeof marker);
  return size == sizeof word && (word | 0x20202020U) == marker;
}

/// Digits, with a point among them or without; no zero leads. `number` is one run.
inline bool is_decimal(Bits digits, Bits points, char const* line, Bits number) {
  Bits const digit = digits & number;
  Bits const point = points & number;
  Bits const behind_zero = Bits{line[first_of(number)] == '0'} * (lowest(number) << 1U);
  Bits const wrong = (number & ~(digit | point)) | (point & (point - 1)) | (digit & behind_zero);
  return wrong == 0 && digit != 0;
}

inline bool is_sign(char byte) {
  return byte == '+' || byte == '-';
}

inline bool is_hexadecimal(char byte) {
  bool const is_digit = '0' <= byte && byte <= '9';
  return is_digit || ('a' <= (byte | 0x20) && (byte | 0x20) <= 'f');
}

/// Hexadecimal or with an exponent; `word` stands for what the grammar has to look at. `number` is `token` without sign
/// and contains `letters`.
inline ValueKind kind_with_letters(TextBlock const& block, char const* line, Bits token, Bits number,
                                   Bits letters) {
  Bits const letter = lowest(letters);
  Bits const before = number & (letter - 1);
  Bits behind = number & ~before & ~letter;
  char const* byte = line + first_of(letter);
  char const* const end = line + end_of(number);
  if (before == 0 || behind == 0) return ValueKind::word;
  if (*byte == 'x' || *byte == 'X') {
    bool const is_prefix = number == token && before == lowest(number) && byte[-1] == '0';
    ++byte;
    while (byte != end && is_hexadecimal(*byte)) ++byte;
    return is_prefix && byte == end ? ValueKind::hexadecimal : ValueKind::word;
  }
  if (is_sign(byte[1])) behind &= behind - 1;
  bool const good = (*byte == 'e' || *byte == 'E') && behind != 0 && (behind & ~block.digit()) == 0 &&
                    is_decimal(block.digit(), block.point(), line, before);
  return good ? ValueKind::real : ValueKind::word;
}

/// What a trailer's first byte says; a slash needs a second look.
struct TrailerKinds {
  constexpr TrailerKinds() {
    for (TrailerKind& kind : of) kind = TrailerKind::text;
    of[static_cast<unsigned char>('(')] = TrailerKind::parenthesis;
    of[static_cast<unsigned char>('#')] = TrailerKind::hash;
  }
  TrailerKind of[256] = {};
};
inline constexpr TrailerKinds trailer_kinds{};

inline TrailerKind trailer_kind(char const* trailer, char const* end) {
  TrailerKind const kind = trailer_kinds.of[static_cast<unsigned char>(*trailer)];
  if (*trailer == '/' && end - trailer > 1 && trailer[1] == '*') return TrailerKind::slash_star;
  return trailer == end ? TrailerKind::none : kind;
}

}  // namespace axisc::grammar::AXISC_LEVEL
