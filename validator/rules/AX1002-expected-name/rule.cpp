#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/syntax_problems.hpp"

namespace axisc::validator::says {

constexpr Sentence headline{"a line begins with a parameter name, a comment or `Ende`",
                            "eine Zeile beginnt mit einem Parameternamen, einem Kommentar oder `Ende`"};
constexpr Sentence reaction{"it ignores the line", "sie übergeht die Zeile"};
constexpr Sentence fix{"make it a comment", "zum Kommentar machen"};

}  // namespace axisc::validator::says

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
  finding.message = message(says::headline);
  set_reaction(finding, says::reaction);
  if (!opens_foreign_comment(context.source.slice(problem.span))) return;
  Span const before{.begin = problem.span.begin, .end = problem.span.begin};
  finding.fix = replace_by(place_of(context, before), "# ", message(says::fix), FixSafety::safe);
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
