// An axis parameter list as a tree with spans. The grammar knows how a list is written, not which parameters
// exist.
//
// Reading never stops: every line is judged by itself, and a line with a problem contributes no assignment.
// Questions that only the catalogue can decide stay open here: whether a word is a symbol or a free string,
// and therefore where a comment after it may begin. For that an assignment carries the token and the rest of
// the line.
#pragma once

#include "diagnostics/source_text.hpp"
#include "diagnostics/span.hpp"
#include "grammar/directive.hpp"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace axisc::grammar {

enum class ValueKind : std::uint8_t {
  integer,        ///< 20, -5, +5
  hexadecimal,    ///< 0x400001
  real,           ///< 1.8, .5, 1., 3.000000e+001
  word,           ///< LOWPASS, TRUE, X_Achse: begins with a letter or underscore, ends at a blank or `(`
  quoted,         ///< "name (with bracket)"; the span includes the quotes
  reference,      ///< P-AXIS-00212 or P-AXIS-00212.0
  decimal_comma,  ///< 1,8
  /// Begins like a number but is not one: 12abc, 0x, 1e, 007; a string such as 5.12.34.56.1.1 may, too.
  malformed_number,
  other,  ///< anything else that does not begin a comment: /path, %x
};

/// How the text after the value token begins (meaningful after numbers, booleans and references).
enum class TrailerKind : std::uint8_t { none, parenthesis, hash, slash_star, text };

/// `name value [trailer]`. All spans are byte offsets into the parsed bytes.
struct Assignment {
  Span name;   ///< as written: `filter[0].order`
  Span value;  ///< the value token
  /// Text after the value token, without surrounding blanks; empty at the line's end if there is none.
  Span trailer;
  std::uint32_t line = 0;  ///< from 1
  ValueKind kind = ValueKind::word;
  TrailerKind trailer_kind = TrailerKind::none;

  friend bool operator==(Assignment const&, Assignment const&) = default;
};

/// From the value token to the first `(` outside quotes or the line's end, without trailing blanks: the value
/// of a parameter that takes any text. Cost: a search through the rest of the line.
[[nodiscard]] Span free_text(std::string_view bytes, Assignment const& assignment);

enum class ProblemKind : std::uint8_t {
  invalid_character,    ///< AX1001: control character, NUL, lone CR, or a byte undefined in the encoding
  expected_name,        ///< AX1002
  expected_value,       ///< AX1003: span is the name
  malformed_index,      ///< AX1004: span is from `[` to the end of the broken index
  text_after_end,       ///< AX1008: first non-blank line after `Ende`; reported once
  unterminated_string,  ///< AX1012: span is from the quote to the line's end
};

struct Problem {
  ProblemKind kind{};
  Span span;
  std::uint32_t line = 0;

  friend bool operator==(Problem const&, Problem const&) = default;
};

struct AxisList {
  std::vector<Assignment> assignments;
  std::vector<Problem> problems;
  std::vector<Directive> directives;
  std::optional<Span> end_marker;  ///< the word `Ende`, in whatever letter case it was written
  std::uint32_t lines = 0;         ///< a line end closes its line and opens no further one

  friend bool operator==(AxisList const&, AxisList const&) = default;
};

/// Longest line that is read, in bytes (a longer one is AX9003 for the file).
inline constexpr std::size_t longest_line = 1U << 20U;

/// `bytes` without byte order mark begins at `text_begin`; `windows_1252` chooses which bytes above 0x7F are
/// letters and which are undefined; `lines_before` of its file come before `bytes`. Cost: one pass, linear
/// also in the number of problems. The caller has checked that no line is longer than `longest_line` (see
/// `longest_line_in`).
[[nodiscard]] AxisList parse_axis_list(std::string_view bytes, std::uint32_t text_begin, bool windows_1252,
                                       std::uint32_t lines_before = 0);

/// The list of a source, in its encoding.
[[nodiscard]] AxisList parse_axis_list(SourceText const& source);

/// Length of the longest line of `bytes`.
[[nodiscard]] std::size_t longest_line_in(std::string_view bytes);

}  // namespace axisc::grammar
