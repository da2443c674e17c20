#include "validator/engine/rule.hpp"

#include "validator/rules/end_marker.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/syntax_problems.hpp"

namespace axisc::validator::checks::ax1003::says {

constexpr Sentence headline{"`{name}` has no value", "`{name}` hat keinen Wert"};
constexpr Sentence help{"write the value after the name, separated by a blank",
                        "den Wert nach dem Namen schreiben, durch ein Leerzeichen getrennt"};

}  // namespace axisc::validator::checks::ax1003::says

namespace axisc::validator::checks::ax1003 {
namespace {

void describe(Finding& finding, ListContext const& context, grammar::Problem const& problem) {
  if (describe_end_marker(finding, context, problem)) return;
  finding.parameter = context.source.utf8(problem.span);
  finding.message = message_of(says::headline, Argument{"name", finding.parameter});
  finding.help.push_back(message(says::help));
}

void expected_value(ListContext const& context, Report& report) {
  report_problems<describe>(context, grammar::ProblemKind::expected_value, report);
}

}  // namespace

extern constinit Rule const rule{
    .check = expected_value,
};

}  // namespace axisc::validator::checks::ax1003
