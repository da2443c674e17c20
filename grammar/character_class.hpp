// The classes of bytes that axis lists and NC programs distinguish, as one table.
#pragma once

#include <array>
#include <cstdint>

namespace axisc::grammar {

/// A set of character classes, one bit each.
using CharacterClasses = std::uint16_t;

namespace character {
inline constexpr CharacterClasses blank = 1U << 0U;        ///< space, tab
inline constexpr CharacterClasses letter = 1U << 1U;       ///< A..Z, a..z, underscore: begins an identifier
inline constexpr CharacterClasses digit = 1U << 2U;        ///< 0..9
inline constexpr CharacterClasses hexadecimal = 1U << 3U;  ///< 0..9, A..F, a..f
inline constexpr CharacterClasses parenthesis = 1U << 4U;  ///< ( opens a comment
inline constexpr CharacterClasses high = 1U << 5U;         ///< above 0x7F: part of words, never of names
inline constexpr CharacterClasses control = 1U << 6U;      ///< below 0x20 except the tab, and 0x7F
inline constexpr CharacterClasses sign = 1U << 7U;         ///< + and -
inline constexpr CharacterClasses quote = 1U << 8U;        ///< "
inline constexpr CharacterClasses line_end = 1U << 9U;    ///< LF, between the lines of one block of a program
inline constexpr CharacterClasses bracket = 1U << 10U;    ///< [ and ]
inline constexpr CharacterClasses equals = 1U << 11U;     ///< =
inline constexpr CharacterClasses semicolon = 1U << 12U;  ///< ; opens a comment of a program
}  // namespace character

namespace detail {

constexpr std::array<CharacterClasses, 256> make_class_table() {
  std::array<CharacterClasses, 256> table{};
  auto const add = [&table](unsigned first, unsigned last, CharacterClasses classes) {
    for (unsigned byte = first; byte <= last; ++byte) {
      table[byte] = static_cast<CharacterClasses>(table[byte] | classes);
    }
  };
  add(0x00, 0x1F, character::control);
  add(0x7F, 0x7F, character::control);
  add('0', '9', character::digit | character::hexadecimal);
  add('A', 'Z', character::letter);
  add('a', 'z', character::letter);
  add('_', '_', character::letter);
  add('A', 'F', character::hexadecimal);
  add('a', 'f', character::hexadecimal);
  add('(', '(', character::parenthesis);
  add('"', '"', character::quote);
  add('\n', '\n', character::line_end);
  add('[', '[', character::bracket);
  add(']', ']', character::bracket);
  add('=', '=', character::equals);
  add(';', ';', character::semicolon);
  add('+', '+', character::sign);
  add('-', '-', character::sign);
  add(0x80, 0xFF, character::high);
  table[' '] = character::blank;
  table['\t'] = character::blank;
  return table;
}

inline constexpr std::array<CharacterClasses, 256> class_table = make_class_table();

}  // namespace detail

/// True if `byte` belongs to at least one of `classes`.
constexpr bool is(CharacterClasses classes, char byte) {
  return (detail::class_table[static_cast<unsigned char>(byte)] & classes) != 0;
}

}  // namespace axisc::grammar
