// Which bytes axis lists and NC programs tell apart, as one table, and the Spirit X3 primitives over it.
//
// X3's own character parsers ask the C locale or compare ranges one by one; a table of 256 entries is neither
// dependent on the surroundings nor slower for a larger class.
#pragma once

#include <array>
#include <cstdint>

#include <boost/spirit/home/x3.hpp>

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

namespace x3 = boost::spirit::x3;

/// Matches one byte of the classes; no attribute.
template <CharacterClasses classes>
struct OneOf : x3::parser<OneOf<classes>> {
  using attribute_type = x3::unused_type;
  static bool const has_attribute = false;

  template <typename Iterator, typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, Iterator const& last, Context const& /*context*/, RuleContext& /*rule_context*/,
             Attribute& /*attribute*/) const {
    if (first == last || !is(classes, *first)) return false;
    ++first;
    return true;
  }
};

/// Matches the longest run of bytes that belong to the classes (`inside`) or to none of them, at least
/// `minimum` (0 or 1).
template <CharacterClasses classes, bool inside, int minimum>
struct RunOf : x3::parser<RunOf<classes, inside, minimum>> {
  using attribute_type = x3::unused_type;
  static bool const has_attribute = false;

  template <typename Iterator, typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, Iterator const& last, Context const& /*context*/, RuleContext& /*rule_context*/,
             Attribute& /*attribute*/) const {
    Iterator position = first;
    while (position != last && is(classes, *position) == inside) ++position;
    if constexpr (minimum > 0) {
      if (position == first) return false;
    }
    first = position;
    return true;
  }
};

/// Matches whatever is left.
struct Rest : x3::parser<Rest> {
  using attribute_type = x3::unused_type;
  static bool const has_attribute = false;

  template <typename Iterator, typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, Iterator const& last, Context const& /*context*/, RuleContext& /*rule_context*/,
             Attribute& /*attribute*/) const {
    first = last;
    return true;
  }
};

template <CharacterClasses classes>
inline constexpr OneOf<classes> one_of{};
template <CharacterClasses classes>
inline constexpr RunOf<classes, true, 0> any_of{};
template <CharacterClasses classes>
inline constexpr RunOf<classes, true, 1> some_of{};
/// Everything up to the first byte of the classes, at least one byte.
template <CharacterClasses classes>
inline constexpr RunOf<classes, false, 1> some_until{};
/// The same, also when there is none.
template <CharacterClasses classes>
inline constexpr RunOf<classes, false, 0> any_until{};
inline constexpr Rest rest{};

}  // namespace axisc::grammar
