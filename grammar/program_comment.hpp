// Comments of NC programs, and the gaps between tokens in which they are allowed.
//
// `(` opens a comment that its `)` closes, or the line's end; comments nest. `;` opens one up to the line's
// end. They are followed by counting, not by a rule that calls itself: no input may drive the depth of our
// stack.
#pragma once

#include "grammar/character_class.hpp"
#include "grammar/character_parsers.hpp"

#include <boost/spirit/home/x3.hpp>

namespace axisc::grammar {

[[nodiscard]] constexpr bool opens_comment(char byte) {
  return is(character::parenthesis | character::semicolon, byte);
}

/// The place after the comment that opens at `first`; a line's end does not belong to it.
[[nodiscard]] constexpr char const* behind_comment(char const* first, char const* last) {
  bool const to_line_end = *first == ';';
  int depth = 0;
  for (; first != last && !is(character::line_end, *first); ++first) {
    if (to_line_end) continue;
    if (*first == '(') ++depth;
    if (*first == ')' && --depth == 0) return first + 1;
  }
  return first;
}

/// Matches blanks, line ends inside a block, and comments, or nothing; no attribute.
struct Gap : x3::parser<Gap> {
  using attribute_type = x3::unused_type;
  static bool const has_attribute = false;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(char const*& first, char const* const& last, Context const& /*context*/,
             RuleContext& /*rule_context*/, Attribute& /*attribute*/) const {
    while (first != last) {
      if (is(character::blank | character::line_end, *first)) {
        ++first;
      } else if (opens_comment(*first)) {
        first = behind_comment(first, last);
      } else {
        break;
      }
    }
    return true;
  }
};

}  // namespace axisc::grammar
