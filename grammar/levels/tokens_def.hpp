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

/// Zero if the run `name`, behind which a blank follows, is a name. Begins and points are followed by letters. Brackets stand
/// behind a name, are filled with digits, and are followed by a point or nothing: an addition carries from behind every opening
/// bracket through its digits, to where the closing one has to be.
AXISC_INLINE Bits wrong_in_name(TextBlock const& block, Bits name) {
  Bits const letter = block.letter();
  Bits const digit = block.digit();
  Bits const point = block.point() & name;
  Bits const opening = block.opening() & name;
  Bits const closing = block.closing() & name;
  Bits const identifier = letter | digit;
  Bits const inside = opening << 1U;
  Bits const behind_digits = (digit + inside) & ~digit;
  Bits const behind_closing = (closing << 1U) & name;
  return (name & ~(identifier | point | opening | closing)) | ((lowest(name) | point << 1U) & ~letter) |
         (inside & ~digit) | (behind_digits ^ closing) | ((opening >> 1U) & ~identifier) |
         (behind_closing & ~point);
}

/// `Ende` in any letter case.
inline bool is_end_marker(char const* name, unsigned size) {
  if (size != 4) return false;
  std::uint32_t word = 0;
  std::uint32_t marker = 0;
  std::memcpy(&word, name, sizeof word);
  std::memcpy(&marker, "ende", sizeof marker);
  return (word | 0x20202020U) == marker;
}

inline bool is_sign(char byte) {
  return byte == '+' || byte == '-';
}

inline bool is_hexadecimal(char byte) {
  bool const is_digit = '0' <= byte && byte <= '9';
  return is_digit || ('a' <= (byte | 0x20) && (byte | 0x20) <= 'f');
}

/// Digits, with a point among them or without; no zero leads. `number` is one run.
inline bool is_decimal(Bits digits, Bits points, char const* line, Bits number) {
  Bits const digit = digits & number;
  Bits const point = points & number;
  Bits const behind_zero = Bits{line[first_of(number)] == '0'} * (lowest(number) << 1U);
  Bits const wrong = (number & ~(digit | point)) | (point & (point - 1)) | (digit & behind_zero);
  return wrong == 0 && digit != 0;
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

/// What a trailer's first byte says; a slash needs a second look. Where there is no trailer, blanks or the line's end stand
/// there.
struct TrailerKinds {
  constexpr TrailerKinds() {
    for (TrailerKind& kind : of) kind = TrailerKind::text;
    of[static_cast<unsigned char>('(')] = TrailerKind::parenthesis;
    of[static_cast<unsigned char>('#')] = TrailerKind::hash;
    for (char const byte : {' ', '\t', '\r', '\n'}) of[static_cast<unsigned char>(byte)] = TrailerKind::none;
  }
  TrailerKind of[256] = {};
};
inline constexpr TrailerKinds trailer_kinds{};

inline TrailerKind trailer_kind(char const* trailer) {
  if (trailer[0] == '/' && trailer[1] == '*') return TrailerKind::slash_star;
  return trailer_kinds.of[static_cast<unsigned char>(*trailer)];
}

}  // namespace axisc::grammar::AXISC_LEVEL
