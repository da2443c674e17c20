#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

namespace axisc::validator {

void checks::unknown_parameter(ListContext const& context, Report& report) {
  for_each_doubtful(context.list, [&](grammar::Assignment const& assignment, Reading const& reading) {
    if (reading.row_known()) return;
    Finding& finding = add_at(context, report, assignment, reading, assignment.name,
                              message_of(Text::ax2001, Argument{"name", written_name(context, assignment)}));
    if (is_compiled_family(finding.parameter)) finding.severity = Severity::error;
    set_reaction(finding, Text::ax2001_reaction);
    finding.help.reserve(reading.suggestions.size());
    for (std::string const& suggestion : reading.suggestions) {
      finding.help.push_back(message_of(Text::parameter_did_you_mean, Argument{"suggestion", suggestion}));
    }
    if (reading.suggestions.empty()) return;
    std::string const& best = reading.suggestions.front();
    finding.fix = replace_by(place_of(context, assignment.name), best,
                             message_of(Text::parameter_fix, Argument{"replacement", best}));
  });
}

}  // namespace axisc::validator
