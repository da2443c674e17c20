// How the tokens of an axis list are spelled, stated once: for the grammar (axis_list_def.hpp), for the quick
// reader of plain lines (plain_lines.hpp) and for code that converts their values.
#pragma once

#include "diagnostics/ascii.hpp"
#include "grammar/axis_list.hpp"
#include "grammar/character_class.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

namespace axisc::grammar::lexical {

// A line ends with LF or CR LF.
inline constexpr char line_feed = '\n';
inline constexpr char carriage_return = '\r';

// Comments. The hash opens one everywhere but in strings, the parenthesis ends a word too.
inline constexpr char parenthesis = '(';
inline constexpr char hash = '#';
inline constexpr std::string_view slash_star = "/*";

constexpr bool opens_comment(std::string_view text) {
  return text.starts_with(parenthesis) || text.starts_with(hash) || text.starts_with(slash_star);
}

/// A comment that contains this may be meant for this program, see directive.hpp.
inline constexpr char directive_mark = ':';

/// Ends the list, in any letter case.
inline constexpr std::string_view end_marker = "Ende";

constexpr bool is_end_marker(std::string_view word) {
  return word.size() == end_marker.size() && ascii::equal_ignoring_case(word, end_marker);
}

// Names.
inline constexpr CharacterClasses begins_name = character::letter;
inline constexpr CharacterClasses continues_name = character::letter | character::digit;

// Words continue to the next blank or parenthesis, with whatever precedes it.
inline constexpr CharacterClasses begins_word = character::letter | character::high;
inline constexpr CharacterClasses ends_word = character::blank | character::parenthesis;

// Numbers.
inline constexpr char decimal_point = '.';
/// In either letter case.
inline constexpr std::string_view hexadecimal_prefix = "0x";

constexpr bool begins_hexadecimal(std::string_view token) {
  return ascii::equal_ignoring_case(token.substr(0, hexadecimal_prefix.size()), hexadecimal_prefix);
}

// The value of another parameter.
inline constexpr std::string_view reference_prefix = "P-AXIS-";
inline constexpr int reference_digits = 5;
/// The beginning of every parameter's number: P-AXIS-00212, P-CHAN-00001.
inline constexpr std::string_view parameter_number_prefix = "P-";

/// The kind of a token that consists of letters, digits and underscores; none for other tokens and for those
/// that begin like a number and are not a decimal integer.
constexpr std::optional<ValueKind> simple_kind(std::string_view token) {
  auto const consists_of = [token](CharacterClasses classes) {
    return std::all_of(token.begin(), token.end(), [classes](char byte) { return is(classes, byte); });
  };
  if (token.empty()) return std::nullopt;
  if (is(character::letter, token.front())) {
    return consists_of(character::letter | character::digit) ? std::optional(ValueKind::word) : std::nullopt;
  }
  return consists_of(character::digit) && !ascii::has_leading_zero(token) ? std::optional(ValueKind::integer)
                                                                          : std::nullopt;
}

}  // namespace axisc::grammar::lexical
