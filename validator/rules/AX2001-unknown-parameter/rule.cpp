#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/sentences.hpp"
#include "validator/values/lost_assignment.hpp"

namespace axisc::validator::says {

constexpr Sentence headline{"unknown parameter `{name}`", "unbekannter Parameter `{name}`"};
constexpr Sentence reaction{"it ignores the line", "sie übergeht die Zeile"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
namespace {

void describe(Finding& finding, Line const& line) {
  finding.message = message_of(says::headline, Argument{"name", finding.parameter});
  set_reaction(finding, says::reaction);
  auto const suggestions = line.context.list.readings.suggestions(line.number);
  finding.help.reserve(suggestions.size());
  for (std::string const& suggestion : suggestions) {
    finding.help.push_back(message_of(says::parameter_did_you_mean, Argument{"suggestion", suggestion}));
  }
  if (suggestions.empty()) return;
  std::string const& best = suggestions.front();
  finding.fix = replace_by(line.place(line.assignment().name), best,
                           message_of(says::parameter_fix, Argument{"replacement", best}));
}

void unknown_parameter(ListContext const& context, Report& report) {
  for_each_doubtful(context, [&](Line const& line) {
    if (line.reading().row_known()) return;
    Span const name = line.assignment().name;
    Reported& reported = report_line<describe>(report, line, name);
    if (is_compiled_family(context.source.slice(name))) reported.severity = Severity::error;
  });
}

}  // namespace

extern constinit Rule const ax2001{
    .code = Code{2001},
    .name = "unknown-parameter",
    .severity = Severity::warning,
    .control = "1001119",
    .check = unknown_parameter,
};

}  // namespace axisc::validator::checks
