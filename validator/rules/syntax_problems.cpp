// What the grammar finds: AX1001 to AX1004, AX1008, AX1012.
#include "diagnostics/ascii.hpp"
#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

#include <array>
#include <cstdio>

namespace axisc::validator {
namespace {

using grammar::Problem;
using grammar::ProblemKind;

/// A finding for each problem of a kind; `describe(finding, context, problem)` makes its words.
template <auto describe>
void report_problems(ListContext const& context, ProblemKind kind, Report& report) {
  for (Problem const& problem : context.list.tree.problems) {
    if (problem.kind != kind) continue;
    report.later(place_of(context, problem.span),
                 [&context, &problem](Finding& finding) { describe(finding, context, problem); });
  }
}

std::string hexadecimal(char const* format, unsigned char byte) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), format, byte);
  return text.data();
}

/// How other languages open a comment that takes the rest of the line.
bool opens_foreign_comment(std::string_view word) {
  for (std::string_view const opener : {";", "//", "/*", "(", "*", "--", "'"}) {
    if (word.substr(0, opener.size()) == opener) return true;
  }
  return false;
}

/// `[ 0 ]` and `[0` as `[0]`; empty where no number can be meant.
std::string repaired_index(std::string_view index) {
  std::string digits;
  for (char const character : index) {
    if (ascii::is_digit(character)) digits += character;
  }
  bool const only_blanks_beside = index.find_first_not_of("[]0123456789 \t") == std::string_view::npos &&
                                  index.find('[', 1) == std::string_view::npos;
  return digits.empty() || !only_blanks_beside ? std::string{} : '[' + digits + ']';
}

/// Everything from `begin` to the end of the file becomes comments.
std::vector<Edit> comments_from(ListContext const& context, std::uint32_t begin) {
  SourceText const& source = context.source;
  std::vector<Edit> edits;
  std::uint32_t const first = source.position(begin).line;
  for (std::uint32_t line = first; line <= source.line_count(); ++line) {
    Span span = source.line_span(line);
    if (line == first) span.begin = begin;
    std::string_view const text = source.slice(span);
    std::size_t const content = text.find_first_not_of(" \t");
    if (content == std::string_view::npos || text[content] == '#') continue;
    auto const at = span.begin + static_cast<std::uint32_t>(content);
    edits.push_back({.place = place_of(context, {.begin = at, .end = at}), .text = "# "});
  }
  return edits;
}

void describe_invalid_character(Finding& finding, ListContext const& context, Problem const& problem) {
  auto const byte = static_cast<unsigned char>(context.source.slice(problem.span).front());
  bool const undefined = byte >= 0x80 && context.source.encoding() == Encoding::windows_1252;
  std::string const shown = undefined     ? hexadecimal("0x%02X", byte)
                            : byte < 0x80 ? hexadecimal("U+%04X", byte)
                                          : "U+0080";
  finding.message = message(undefined ? Text::ax1001_undefined : Text::ax1001, {{"character", shown}});
}

void describe_expected_name(Finding& finding, ListContext const& context, Problem const& problem) {
  finding.message = message(Text::ax1002);
  set_reaction(finding, Text::ax1002_reaction);
  if (!opens_foreign_comment(context.source.slice(problem.span))) return;
  Span const before{.begin = problem.span.begin, .end = problem.span.begin};
  finding.fix = replace_by(place_of(context, before), "# ", message(Text::ax1002_fix), FixSafety::safe);
}

void describe_expected_value(Finding& finding, ListContext const& context, Problem const& problem) {
  finding.parameter = context.source.utf8(problem.span);
  finding.message = message_of(Text::ax1003, Argument{"name", finding.parameter});
  finding.help.push_back(message(Text::ax1003_help));
}

void describe_malformed_index(Finding& finding, ListContext const& context, Problem const& problem) {
  std::string const index = context.source.utf8(problem.span);
  finding.message = message_of(Text::ax1004, Argument{"index", index});
  finding.help.push_back(message(Text::ax1004_help));
  std::string const repaired = repaired_index(index);
  if (repaired.empty()) return;
  finding.fix = replace_by(place_of(context, problem.span), repaired,
                           message_of(Text::ax1004_fix, Argument{"replacement", repaired}));
}

void describe_text_after_end(Finding& finding, ListContext const& context, Problem const& problem) {
  finding.message = message(Text::ax1008);
  if (auto const& marker = context.list.tree.end_marker) {
    finding.related.push_back(
        {.place = place_of(context, *marker), .message = message(Text::ax1008_related)});
  }
  finding.fix = Fix{.title = message(Text::ax1008_fix),
                    .edits = comments_from(context, problem.span.begin),
                    .safety = FixSafety::safe};
}

void describe_unterminated_string(Finding& finding, ListContext const& context, Problem const& problem) {
  finding.message = message(Text::ax1012);
  // With a comment on the line nobody knows where the string was meant to end.
  if (context.source.slice(problem.span).find_first_of("(#*") != std::string_view::npos) return;
  Span const behind{.begin = problem.span.end, .end = problem.span.end};
  finding.fix = replace_by(place_of(context, behind), "\"", message(Text::ax1012_fix));
}

}  // namespace

void checks::invalid_character(ListContext const& context, Report& report) {
  report_problems<describe_invalid_character>(context, ProblemKind::invalid_character, report);
}

void checks::expected_name(ListContext const& context, Report& report) {
  report_problems<describe_expected_name>(context, ProblemKind::expected_name, report);
}

void checks::expected_value(ListContext const& context, Report& report) {
  report_problems<describe_expected_value>(context, ProblemKind::expected_value, report);
}

void checks::malformed_index(ListContext const& context, Report& report) {
  report_problems<describe_malformed_index>(context, ProblemKind::malformed_index, report);
}

void checks::text_after_end(ListContext const& context, Report& report) {
  report_problems<describe_text_after_end>(context, ProblemKind::text_after_end, report);
}

void checks::unterminated_string(ListContext const& context, Report& report) {
  report_problems<describe_unterminated_string>(context, ProblemKind::unterminated_string, report);
}

}  // namespace axisc::validator
