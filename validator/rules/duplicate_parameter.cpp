#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

#include <unordered_map>

namespace axisc::validator {

void checks::duplicate_parameter(ListContext const& context, Report& report) {
  std::unordered_map<schema::Slot, std::size_t> last;
  std::vector<Reading> const& readings = context.list.readings;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    // A broken line sets nothing, so it repeats nothing.
    if (!readings[i].usable()) continue;
    auto const [earlier, first] = last.try_emplace(readings[i].name.slot, i);
    if (first) continue;
    grammar::Assignment const& assignment = context.list.tree.assignments[earlier->second];
    grammar::Assignment const& later = context.list.tree.assignments[i];
    Finding& finding = add_at(context, report, assignment, readings[earlier->second], assignment.value,
                              message(Text::ax2006, {{"parameter", written_name(context, assignment)},
                                                     {"line", std::to_string(later.line)}}));
    finding.related.push_back(
        {.place = place_of(context, later.value), .message = message(Text::ax2006_related)});
    // The last one wins, so the earlier line is ignored. One that carries a directive would speak for the next line.
    std::string_view const line = context.source.slice(context.source.line_span(assignment.line));
    if (line.find("axisc:") == std::string_view::npos) {
      Span const before{.begin = assignment.name.begin, .end = assignment.name.begin};
      finding.fix = replace_by(place_of(context, before), "# ", message(Text::ax2006_fix), FixSafety::safe);
    }
    earlier->second = i;
  }
}

}  // namespace axisc::validator
