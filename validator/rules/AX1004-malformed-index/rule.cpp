#include "validator/engine/rule.hpp"

#include "diagnostics/ascii.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/syntax_problems.hpp"

namespace axisc::validator::says {

constexpr Sentence headline{"the index `{index}` is malformed", "der Index `{index}` ist fehlerhaft"};
constexpr Sentence help{
    "an index is a whole number from 0 in brackets, without blanks: `filter[0].order`",
    "ein Index ist eine ganze Zahl ab 0 in eckigen Klammern, ohne Leerzeichen: `filter[0].order`"};
constexpr Sentence fix{"write `{replacement}`", "`{replacement}` schreiben"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
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
  std::string const repaired = repaired_index(index);
  if (repaired.empty()) return;
  finding.fix = replace_by(place_of(context, problem.span), repaired,
                           message_of(says::fix, Argument{"replacement", repaired}));
}

void malformed_index(ListContext const& context, Report& report) {
  report_problems<describe>(context, grammar::ProblemKind::malformed_index, report);
}

}  // namespace

extern constinit Rule const ax1004{
    .code = Code{1004},
    .name = "malformed-index",
    .check = malformed_index,
};

}  // namespace axisc::validator::checks
