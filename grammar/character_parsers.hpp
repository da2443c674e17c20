// Spirit X3 primitives over the table of character classes.
//
// X3's own character parsers ask the C locale or compare ranges one by one; a table of 256 entries is neither
// dependent on the surroundings nor slower for a larger class.
#pragma once

#include "diagnostics/ascii.hpp"
#include "grammar/character_class.hpp"
#include "grammar/lexical.hpp"

#include <cstddef>
#include <iterator>
#include <string_view>

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

/// Matches `text`, or the same but for the case of its ASCII letters; no attribute.
template <bool in_any_case>
struct Text : x3::parser<Text<in_any_case>> {
  using attribute_type = x3::unused_type;
  static bool const has_attribute = false;

  std::string_view text;

  constexpr explicit Text(std::string_view expected) : text(expected) {}

  template <typename Iterator, typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, Iterator const& last, Context const& /*context*/, RuleContext& /*rule_context*/,
             Attribute& /*attribute*/) const {
    if (static_cast<std::size_t>(last - first) < text.size()) return false;
    std::string_view const found(&*first, text.size());
    if (in_any_case ? !ascii::equal_ignoring_case(found, text) : found != text) return false;
    first += static_cast<std::ptrdiff_t>(text.size());
    return true;
  }
};

/// Matches nothing, where `fact` holds for the text from here on; no attribute.
template <auto fact>
struct Where : x3::parser<Where<fact>> {
  using attribute_type = x3::unused_type;
  static bool const has_attribute = false;

  template <typename Iterator, typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, Iterator const& last, Context const& /*context*/, RuleContext& /*rule_context*/,
             Attribute& /*attribute*/) const {
    return fact(first == last ? std::string_view()
                              : std::string_view(&*first, static_cast<std::size_t>(last - first)));
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
/// Like the one above, but succeeds also without a match.
template <CharacterClasses classes>
inline constexpr RunOf<classes, false, 0> any_until{};
inline constexpr Rest rest{};
constexpr Text<false> exactly(std::string_view text) {
  return Text<false>(text);
}
constexpr Text<true> any_case(std::string_view text) {
  return Text<true>(text);
}
template <auto fact>
inline constexpr Where<fact> where{};

}  // namespace axisc::grammar
