// The grammar of one block of an NC program, in Spirit X3. A block reaches it as one text, however many lines
// it has; words and commands are parsed one by one, so a block of any length needs no memory.
//
//   block = [skip] [block number] { word | command }
//
// Between any two of them may be blanks and comments.
#pragma once

#include "grammar/nc_command_def.hpp"
#include "grammar/nc_program.hpp"

namespace axisc::grammar::block_syntax {

struct WordToken {
  WordKind kind = WordKind::other;
  Range text;
};

}  // namespace axisc::grammar::block_syntax

BOOST_FUSION_ADAPT_STRUCT(axisc::grammar::block_syntax::WordToken, kind, text)

namespace axisc::grammar::block_syntax {

// A comment over several lines: only a block number may precede its commands.
inline constexpr auto block_number = 'N' >> digits;
inline constexpr auto comment_begin =
    gap >> -block_number >> gap >> "#COMMENT" >> inner_blanks >> "BEGIN" >> word_end;
inline constexpr auto comment_end =
    gap >> -block_number >> gap >> "#COMMENT" >> inner_blanks >> "END" >> word_end;

// Words.
inline constexpr auto skip = '/' >> any_of<character::digit>;
inline constexpr auto title_part =
    some_until<character::blank | character::line_end | character::parenthesis | character::quote |
               character::semicolon>;
inline constexpr auto title = '%' >> -title_part >> *(some_of<character::blank> >> title_part);
inline constexpr auto name = identifier >> *('.' >> identifier);
inline constexpr auto address = one_of<character::letter> >> coordinate >> !lit('=');

inline constexpr auto block_start = x3::rule<struct BlockStartRule, WordToken>{"block_start"} =
    attr(WordKind::skip) >> raw[skip]  //
    | attr(WordKind::block_number) >> raw[block_number];

inline constexpr auto word = x3::rule<struct WordRule, WordToken>{"word"} =
    attr(WordKind::address) >> raw[address]              //
    | attr(WordKind::name) >> raw[name]                  //
    | attr(WordKind::number) >> raw[coordinate]          //
    | attr(WordKind::text) >> raw[text]                  //
    | attr(WordKind::program) >> raw[title]              //
    | attr(WordKind::control) >> raw['$' >> identifier]  //
    | attr(WordKind::other) >> raw[x3::char_];

}  // namespace axisc::grammar::block_syntax
