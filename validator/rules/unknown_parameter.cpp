#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

namespace axisc::validator {

void checks::unknown_parameter(ListContext const& context, Report& report) {
  for (std::uint32_t const number : context.list.readings.doubtful()) {
    grammar::Assignment const& assignment = context.list.tree.assignments[number];
    Reading const& reading = context.list.readings[number];
    if (reading.row_known()) continue;
    Finding& finding = add_at(context, report, assignment, reading, assignment.name,
                              message_of(Text::ax2001, Argument{"name", written_name(context, assignment)}));
    if (is_compiled_family(finding.parameter)) finding.severity = Severity::error;
    set_reaction(finding, Text::ax2001_reaction);
    auto const suggestions = context.list.readings.suggestions(number);
    finding.help.reserve(suggestions.size());
    for (std::string const& suggestion : suggestions) {
      finding.help.push_back(message_of(Text::parameter_did_you_mean, Argument{"suggestion", suggestion}));
    }
    if (suggestions.empty()) continue;
    std::string const& best = suggestions.front();
    finding.fix = replace_by(place_of(context, assignment.name), best,
                             message_of(Text::parameter_fix, Argument{"replacement", best}));
  }
}

}  // namespace axisc::validator
