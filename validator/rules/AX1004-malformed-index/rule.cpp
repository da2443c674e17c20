#include "validator/engine/rule.hpp"

#include "diagnostics/ascii.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/syntax_problems.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax1004::says {

constexpr Sentence headline{"the index `{index}` is malformed", "der Index `{index}` ist fehlerhaft"};
constexpr Sentence blank{"no blank before the index `{index}`", "kein Leerzeichen vor dem Index `{index}`"};
constexpr Sentence reaction{"it ignores the line", "sie übergeht die Zeile"};
constexpr Sentence help{
    "an index is a whole number from 0 in brackets, without blanks: `filter[0].order`",
    "ein Index ist eine ganze Zahl ab 0 in eckigen Klammern, ohne Leerzeichen: `filter[0].order`"};
constexpr Sentence fix{"write `{replacement}`", "`{replacement}` schreiben"};

}  // namespace axisc::validator::checks::ax1004::says

namespace axisc::validator::checks::ax1004 {
namespace {

/// `[ 0 ]` and `[0` as `[0]`; empty if no number can be intended.
std::string repaired_index(std::string_view index) {
  std::string digits;
  for (char const character : index) {
    if (ascii::is_digit(character)) digits += character;
  }
  bool const only_blanks_beside = index.find_first_not_of("[]0123456789 \t") == std::string_view::npos &&
                                  index.find('[', 1) == std::string_view::npos;
  return digits.empty() || !only_blanks_beside ? std::string{} : '[' + digits + ']';
}

void describe(Finding& finding, ListContext const& context, grammar::Problem const& problem) {
  std::string const index = context.source.utf8(problem.span);
  finding.message = message_of(says::headline, Argument{"index", index});
  finding.help.push_back(message(says::help));
  // The following text belongs to the index in `[0,1]`.
  std::string_view const after = context.source.slice(context.source.line_span(problem.line))
                                     .substr(problem.span.end - context.source.line_span(problem.line).begin);
  bool const is_whole = after.empty() || after.front() == '.' || ascii::is_blank(after.front());
  std::string const repaired = repaired_index(index);
  if (repaired.empty() || !is_whole) return;
  finding.fix = replace_by(place_of(context, problem.span), repaired,
                           message_of(says::fix, Argument{"replacement", repaired}));
}

/// The index that a blank separates from its name, in `filter [0].order 2`; empty where there is none.
Span separate_index(Line const& line) {
  Span span = line.assignment().value;
  std::string_view const value = line.context.source.slice(span);
  std::size_t const end = value.find("].");
  if (line.line_value().row_known() || !value.starts_with('[') || end == std::string_view::npos || end < 2) {
    return {};
  }
  if (!std::all_of(value.begin() + 1, value.begin() + static_cast<std::ptrdiff_t>(end), ascii::is_digit)) {
    return {};
  }
  span.end = span.begin + static_cast<std::uint32_t>(end) + 1;
  return span;
}

void describe_separate(Finding& finding, Line const& line) {
  Span const index = separate_index(line);
  Span const name = line.assignment().name;
  finding.parameter = line.name() + line.text(line.assignment().value);
  finding.message = message_of(says::blank, Argument{"index", line.text(index)});
  set_reaction(finding, says::reaction);
  finding.fix = replace_by(line.place({.begin = name.end, .end = index.begin}), {},
                           message_of(says::fix, Argument{"replacement", finding.parameter}));
}

/// `linkage[0][1]`: some names of other kinds of lists have two indices at one part. Their lines are not
/// judged.
bool is_of_other_kind(ListContext const& context, grammar::Problem const& problem) {
  std::string_view const index = context.source.slice(problem.span);
  return context.list.kind != configuration::ListKind::axis && index.find("][") != std::string_view::npos &&
         index.find_first_not_of("[]0123456789") == std::string_view::npos;
}

void malformed_index(ListContext const& context, Report& report) {
  for (grammar::Problem const& problem : context.list.tree.problems) {
    bool const is_wrong =
        problem.kind == grammar::ProblemKind::malformed_index && !is_of_other_kind(context, problem);
    if (is_wrong) report_problem<describe>(context, problem, report);
  }
  for_each_doubtful(context, [&](Line const& line) {
    Span const index = separate_index(line);
    if (index.empty()) return;
    report_line<describe_separate>(report, line, {.begin = line.assignment().name.begin, .end = index.end});
  });
}

}  // namespace

extern constinit Rule const rule{
    .check = malformed_index,
};

}  // namespace axisc::validator::checks::ax1004
