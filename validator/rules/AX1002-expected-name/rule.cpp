#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/syntax_problems.hpp"

namespace axisc::validator::checks {
namespace {

/// How other languages open a comment that takes the rest of the line.
bool opens_foreign_comment(std::string_view word) {
  for (std::string_view const opener : {";", "//", "/*", "(", "*", "--", "'"}) {
    if (word.substr(0, opener.size()) == opener) return true;
  }
  return false;
}

void describe(Finding& finding, ListContext const& context, grammar::Problem const& problem) {
  finding.message = message(Text::ax1002);
  set_reaction(finding, Text::ax1002_reaction);
  if (!opens_foreign_comment(context.source.slice(problem.span))) return;
  Span const before{.begin = problem.span.begin, .end = problem.span.begin};
  finding.fix = replace_by(place_of(context, before), "# ", message(Text::ax1002_fix), FixSafety::safe);
}

void expected_name(ListContext const& context, Report& report) {
  report_problems<describe>(context, grammar::ProblemKind::expected_name, report);
}

}  // namespace

extern constinit Rule const ax1002{
    .code = Code{1002},
    .name = "expected-name",
    .check = expected_name,
};

}  // namespace axisc::validator::checks
