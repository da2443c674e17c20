// The grammar of one line of an axis list, in Spirit X3, over the lexical facts of lexical.hpp. Comment lines
// and blank lines never reach it, blanks around the line are cut off, and which character is allowed at all
// has been checked.
//
//   line       = end | assignment
//   end        = "Ende" in any letter case, as a whole word
//   assignment = name blanks value [trailer]
//   name       = segment { "." segment }         segment = identifier [ "[" digits "]" ]
//   value      = number | reference | word | quoted | other
//   trailer    = everything after the value
#pragma once

#include "grammar/axis_list.hpp"
#include "grammar/character_class.hpp"
#include "grammar/character_parsers.hpp"
#include "grammar/lexical.hpp"
#include "grammar/must.hpp"

#include <boost/fusion/include/adapt_struct.hpp>
#include <boost/range/iterator_range_core.hpp>
#include <boost/spirit/home/x3.hpp>

namespace axisc::grammar::syntax {

using Range = boost::iterator_range<char const*>;

struct ValueToken {
  ValueKind kind = ValueKind::other;
  Range text;
};

struct Trailer {
  TrailerKind kind = TrailerKind::none;
  Range text;
};

struct AssignmentLine {
  Range name;
  ValueToken value;
  Trailer trailer;
};

}  // namespace axisc::grammar::syntax

BOOST_FUSION_ADAPT_STRUCT(axisc::grammar::syntax::ValueToken, kind, text)
BOOST_FUSION_ADAPT_STRUCT(axisc::grammar::syntax::Trailer, kind, text)
BOOST_FUSION_ADAPT_STRUCT(axisc::grammar::syntax::AssignmentLine, name, value, trailer)

namespace axisc::grammar::syntax {

using x3::attr;
using x3::eoi;
using x3::lit;
using x3::omit;
using x3::raw;

// Blanks and where a token stops.
inline constexpr auto blanks = some_of<character::blank>;
inline constexpr auto token_end = &one_of<character::blank> | eoi;
inline constexpr auto word_end = &one_of<lexical::ends_word> | eoi;
inline constexpr auto comment_opener = where<lexical::opens_comment>;

// Names.
inline constexpr auto identifier = one_of<lexical::begins_name> >> any_of<lexical::continues_name>;
inline constexpr auto index = lit('[') >> some_of<character::digit> >> ']' >> !lit('[');
inline constexpr auto segment = identifier >> -(&lit('[') >> must<ProblemKind::malformed_index>[index]);
inline constexpr auto name = raw[segment >> *('.' >> segment) >> token_end];

// How far a broken index reaches: `[ 0 ]`, `[-1]`, `[0][1]` up to the bracket that closes it, `[` and `[0`
// otherwise.
inline constexpr auto closed_index =
    '[' >> any_of<character::blank | character::letter | character::digit | character::sign> >> ']';
inline constexpr auto open_index = '[' >> any_of<character::letter | character::digit | character::sign>;
inline constexpr auto broken_index = +(closed_index | open_index);

// Numbers. The control takes no leading zeros.
inline constexpr auto digits = some_of<character::digit>;
inline constexpr auto sign = -one_of<character::sign>;
inline constexpr auto point = lit(lexical::decimal_point);
inline constexpr auto whole = !where<ascii::has_leading_zero> >> digits;
inline constexpr auto exponent = any_case("e") >> sign >> digits;
inline constexpr auto integer = sign >> whole;
inline constexpr auto hexadecimal = any_case(lexical::hexadecimal_prefix) >> some_of<character::hexadecimal>;
inline constexpr auto fraction = (whole >> point >> any_of<character::digit>) | (point >> digits);
inline constexpr auto real = sign >> ((fraction >> -exponent) | (whole >> exponent));
inline constexpr auto decimal_comma = sign >> whole >> ',' >> digits >> -exponent;
inline constexpr auto number_like = sign >> -point >> one_of<character::digit> >> any_until<character::blank>;

// The value of another parameter, with the index of its first array dimension.
inline constexpr auto reference = exactly(lexical::reference_prefix) >>
                                  x3::repeat(lexical::reference_digits)[one_of<character::digit>] >>
                                  -('.' >> digits);

// Words end at a parenthesis also without a blank: after them only `(` opens a comment. Quotes protect
// blanks and parentheses, and a quotation followed directly by text is not a string.
inline constexpr auto word = one_of<lexical::begins_word> >> any_until<lexical::ends_word>;
inline constexpr auto quotation = '"' >> any_until<character::quote> >> '"';
inline constexpr auto quoted = quotation >> word_end;
inline constexpr auto closed_if_quoted = (!lit('"')) | must<ProblemKind::unterminated_string>[&quotation];
inline constexpr auto other = -quotation >> any_until<character::blank>;

// A number counts only as a whole token; a token that merely begins like one is a malformed number, so the
// order matters.
inline constexpr auto value = x3::rule<struct ValueRule, ValueToken>{"value"} =
    attr(ValueKind::integer) >> raw[integer >> token_end]                //
    | attr(ValueKind::reference) >> raw[reference >> word_end]           //
    | attr(ValueKind::word) >> raw[word]                                 //
    | attr(ValueKind::real) >> raw[real >> token_end]                    //
    | attr(ValueKind::hexadecimal) >> raw[hexadecimal >> token_end]      //
    | attr(ValueKind::quoted) >> raw[quoted]                             //
    | attr(ValueKind::decimal_comma) >> raw[decimal_comma >> token_end]  //
    | attr(ValueKind::malformed_number) >> raw[number_like]              //
    | attr(ValueKind::other) >> raw[other];

inline constexpr auto trailer = x3::rule<struct TrailerRule, Trailer>{"trailer"} =
    omit[any_of<character::blank>] >>
    (attr(TrailerKind::none) >> raw[eoi]                                            //
     | attr(TrailerKind::parenthesis) >> raw[&lit(lexical::parenthesis) >> rest]    //
     | attr(TrailerKind::hash) >> raw[&lit(lexical::hash) >> rest]                  //
     | attr(TrailerKind::slash_star) >> raw[&exactly(lexical::slash_star) >> rest]  //
     | attr(TrailerKind::text) >> raw[rest]);

inline constexpr auto assignment = x3::rule<struct AssignmentRule, AssignmentLine>{"assignment"} =
    must<ProblemKind::expected_name>[name] >> must<ProblemKind::expected_value>[blanks >> !comment_opener] >>
    closed_if_quoted >> value >> trailer;

inline constexpr auto end_marker = raw[any_case(lexical::end_marker) >> token_end];

}  // namespace axisc::grammar::syntax
