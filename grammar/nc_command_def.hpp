// The grammar of one command of an NC program, in Spirit X3.
//
//   command  = name [ "ON" | "OFF" ] [ "[" { keyword } "]" ]       (#FILTER and #VIB GUARD)
//   keyword  = identifier [ "=" value ]
//   value    = number | variable | any other text
//
// Between any two of them is a gap: blanks and comments.
#pragma once

#include "grammar/character_class.hpp"
#include "grammar/character_parsers.hpp"
#include "grammar/must.hpp"
#include "grammar/nc_command.hpp"
#include "grammar/program_comment.hpp"

#include <vector>

#include <boost/fusion/include/adapt_struct.hpp>
#include <boost/range/iterator_range_core.hpp>
#include <boost/spirit/home/x3.hpp>

namespace axisc::grammar::block_syntax {

using Range = boost::iterator_range<char const*>;

struct CommandName {
  CommandKind kind = CommandKind::other;
  Range text;
};

struct ValueToken {
  KeywordValue kind = KeywordValue::none;
  Range text;
};

struct KeywordToken {
  Range name;
  ValueToken value;
};

struct Brackets {
  Range opening;
  std::vector<KeywordToken> keywords;
};

struct CommandBody {
  CommandSwitch command_switch = CommandSwitch::none;
  Brackets brackets;
};

}  // namespace axisc::grammar::block_syntax

BOOST_FUSION_ADAPT_STRUCT(axisc::grammar::block_syntax::CommandName, kind, text)
BOOST_FUSION_ADAPT_STRUCT(axisc::grammar::block_syntax::ValueToken, kind, text)
BOOST_FUSION_ADAPT_STRUCT(axisc::grammar::block_syntax::KeywordToken, name, value)
BOOST_FUSION_ADAPT_STRUCT(axisc::grammar::block_syntax::Brackets, opening, keywords)
BOOST_FUSION_ADAPT_STRUCT(axisc::grammar::block_syntax::CommandBody, command_switch, brackets)

namespace axisc::grammar::block_syntax {

using x3::attr;
using x3::eoi;
using x3::eps;
using x3::lit;
using x3::raw;

/// Matches an upper-case word in any letter case, without asking the locale.
struct AnyCase : x3::parser<AnyCase> {
  using attribute_type = x3::unused_type;
  static bool const has_attribute = false;

  constexpr explicit AnyCase(char const* upper_case) : word(upper_case) {}

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(char const*& first, char const* const& last, Context const& /*context*/,
             RuleContext& /*rule_context*/, Attribute& /*attribute*/) const {
    char const* position = first;
    for (char const* expected = word; *expected != '\0'; ++expected, ++position) {
      if (position == last || (*position != *expected && *position != *expected - 'A' + 'a')) return false;
    }
    first = position;
    return true;
  }

  char const* word;
};

// Gaps and where a token stops.
inline constexpr Gap gap{};
inline constexpr auto inner_blanks = some_of<character::blank | character::line_end>;  // within a name
inline constexpr CharacterClasses value_stops = character::blank | character::line_end | character::bracket |
                                                character::equals | character::parenthesis |
                                                character::semicolon | character::quote;
inline constexpr auto identifier = one_of<character::letter> >> any_of<character::letter | character::digit>;
inline constexpr auto word_end = !one_of<character::letter | character::digit>;
inline constexpr auto value_end = &one_of<value_stops> | eoi;

// A string ends at the line's end where it is not closed.
inline constexpr auto text = '"' >> any_until<character::quote | character::line_end> >> -lit('"');

// Numbers. A program may write leading zeros.
inline constexpr auto digits = some_of<character::digit>;
inline constexpr auto sign = -one_of<character::sign>;
inline constexpr auto fraction = (digits >> '.' >> any_of<character::digit>) | ('.' >> digits);
inline constexpr auto exponent = (lit('e') | 'E') >> sign >> digits;
inline constexpr auto integer = sign >> digits;
inline constexpr auto real = sign >> ((fraction >> -exponent) | (digits >> exponent));
inline constexpr auto coordinate = sign >> (fraction | digits);

// The head of a command. The control wants capitals; in another letter case the two filter commands are
// recognised, so that a finding can be reported.
inline constexpr auto filter_name = '#' >> AnyCase("FILTER") >> word_end;
inline constexpr auto guard_name = '#' >> AnyCase("VIB") >> inner_blanks >> AnyCase("GUARD") >> word_end;
inline constexpr auto exchange_name = '#' >> (lit("CALL") | "PUT" | "SET") >> inner_blanks >> "AX" >> word_end
                                      >> !(gap >> "LINK" >> word_end);
inline constexpr auto other_name = '#' >> any_of<character::letter | character::digit>;

inline constexpr auto command_name = x3::rule<struct CommandNameRule, CommandName>{"command_name"} =
    attr(CommandKind::filter) >> raw[filter_name]             //
    | attr(CommandKind::vibration_guard) >> raw[guard_name]   //
    | attr(CommandKind::axis_exchange) >> raw[exchange_name]  //
    | attr(CommandKind::other) >> raw[other_name];

// Values. Text directly after a number makes it invalid; a keyword that follows directly is not a value.
inline constexpr auto index = '[' >> digits >> ']';
inline constexpr auto variable = ('P' >> digits) | ('V' >> +('.' >> identifier >> *index));
inline constexpr auto value = x3::rule<struct ValueRule, ValueToken>{"value"} =
    attr(KeywordValue::missing) >> raw[&(identifier >> gap >> '=')]  //
    | attr(KeywordValue::integer) >> raw[integer >> value_end]       //
    | attr(KeywordValue::real) >> raw[real >> value_end]             //
    | attr(KeywordValue::variable) >> raw[variable >> value_end]     //
    | attr(KeywordValue::malformed) >> raw[some_until<value_stops>]  //
    | attr(KeywordValue::missing) >> raw[eps];

inline constexpr auto given_value = x3::rule<struct GivenValueRule, ValueToken>{"given_value"} =
    ('=' >> gap >> value) | (attr(KeywordValue::none) >> raw[eps]);

inline constexpr auto keyword = x3::rule<struct KeywordRule, KeywordToken>{"keyword"} =
    raw[identifier] >> gap >> given_value >> gap;

inline constexpr auto keywords = x3::rule<struct KeywordsRule, std::vector<KeywordToken>>{"keywords"} =
    *keyword;

inline constexpr auto brackets = x3::rule<struct BracketsRule, Brackets>{"brackets"} =
    raw[lit('[')] >> gap >> keywords >> must<CommandProblemKind::expected_keyword>[&(lit(']') | eoi)] >>
    must<CommandProblemKind::unclosed_bracket>[lit(']')];

inline constexpr auto command_switch = x3::rule<struct SwitchRule, CommandSwitch>{"switch"} =
    (lit("ON") >> word_end >> attr(CommandSwitch::on))      //
    | (lit("OFF") >> word_end >> attr(CommandSwitch::off))  //
    | attr(CommandSwitch::none);

inline constexpr auto command_body = x3::rule<struct BodyRule, CommandBody>{"body"} =
    gap >> command_switch >> gap >> -brackets >> gap >> must<CommandProblemKind::unexpected_text>[eoi];

}  // namespace axisc::grammar::block_syntax
