#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

namespace axisc::validator {

void checks::unknown_parameter(ListContext const& context, Report& report) {
  for (std::uint32_t const number : context.list.readings.doubtful()) {
    grammar::Assignment const& assignment = context.list.tree.assignments[number];
    Reading const& reading = context.list.readings[number];
    if (reading.row_known()) continue;
    std::string const name = written_name(context, assignment);
    Finding& finding = add_at(context, report, assignment, reading, assignment.name,
                              message(Text::ax2001, {{"name", name}}));
    if (is_compiled_family(name)) finding.severity = Severity::error;
    set_reaction(finding, Text::ax2001_reaction);
    auto const suggestions = context.list.readings.suggestions(number);
    for (std::string const& suggestion : suggestions) {
      finding.help.push_back(message(Text::parameter_did_you_mean, {{"suggestion", suggestion}}));
    }
    if (suggestions.empty()) continue;
    std::string const& best = suggestions.front();
    finding.fix = replace_by(place_of(context, assignment.name), best,
                             message(Text::parameter_fix, {{"replacement", best}}));
  }
}

}  // namespace axisc::validator
