#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace axisc::validator {

void checks::duplicate_parameter(ListContext const& context, Report& report) {
  std::vector<std::uint32_t> last(context.list.catalogue.slot_count(), 0);  // index + 1; 0: not set yet
  Readings const& readings = context.list.readings;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    // A broken line sets nothing, so it repeats nothing.
    if (!readings[i].usable()) continue;
    std::uint32_t const before =
        std::exchange(last[static_cast<std::size_t>(readings[i].slot)], static_cast<std::uint32_t>(i + 1));
    if (before == 0) continue;
    std::size_t const earlier = before - 1;
    grammar::Assignment const& assignment = context.list.tree.assignments[earlier];
    grammar::Assignment const& later = context.list.tree.assignments[i];
    Finding& finding = add_at(context, report, assignment, readings[earlier], assignment.value,
                              message(Text::ax2006, {{"parameter", written_name(context, assignment)},
                                                     {"line", std::to_string(later.line)}}));
    finding.related.push_back(
        {.place = place_of(context, later.value), .message = message(Text::ax2006_related)});
    // The last one wins, so the earlier line is ignored. One that carries a directive would speak for the next line.
    std::string_view const line = context.source.slice(context.source.line_span(assignment.line));
    if (line.find("axisc:") == std::string_view::npos) {
      Span const at_name{.begin = assignment.name.begin, .end = assignment.name.begin};
      finding.fix = replace_by(place_of(context, at_name), "# ", message(Text::ax2006_fix), FixSafety::safe);
    }
  }
}

}  // namespace axisc::validator
