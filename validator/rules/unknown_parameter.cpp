#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

namespace axisc::validator {

void checks::unknown_parameter(ListContext const& context, Report& report) {
  for_each_doubtful(context.list, [&](grammar::Assignment const& assignment, Reading const& reading) {
    if (reading.row_known()) return;
    std::string const name = written_name(context, assignment);
    Finding& finding = add_at(context, report, assignment, reading, assignment.name,
                              message(Text::ax2001, {{"name", name}}));
    if (is_compiled_family(name)) finding.severity = Severity::error;
    set_reaction(finding, Text::ax2001_reaction);
    for (std::string const& suggestion : reading.suggestions) {
      finding.help.push_back(message(Text::parameter_did_you_mean, {{"suggestion", suggestion}}));
    }
    if (reading.suggestions.empty()) return;
    std::string const& best = reading.suggestions.front();
    finding.fix = replace_by(place_of(context, assignment.name), best,
                             message(Text::parameter_fix, {{"replacement", best}}));
  });
}

}  // namespace axisc::validator
