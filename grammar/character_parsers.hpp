// Spirit X3 primitives over the table of character classes.
//
// X3's own character parsers ask the C locale or compare ranges one by one; a table of 256 entries is neither
// dependent on the surroundings nor slower for a larger class.
#pragma once

#include "grammar/character_class.hpp"

#include <boost/spirit/home/x3.hpp>

namespace axisc::grammar {

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
