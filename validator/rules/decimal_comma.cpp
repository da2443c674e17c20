#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

#include <algorithm>

namespace axisc::validator {

void checks::decimal_comma(ListContext const& context, Report& report) {
  for_each_reading(context.list, [&](grammar::Assignment const& assignment, Reading const& reading) {
    if (reading.status != ReadingStatus::decimal_comma) return;
    std::string const value = context.source.utf8(assignment.value);
    Finding& finding = add_at(context, report, assignment, reading, assignment.value,
                              message(Text::ax1005, {{"value", value}}));
    set_reaction(finding, Text::ax1005_reaction);
    std::string with_point = value;
    std::replace(with_point.begin(), with_point.end(), ',', '.');
    if (!is_complete_number(with_point)) return;
    finding.fix = replace_by(place_of(context, assignment.value), with_point,
                             message(Text::ax1005_fix, {{"replacement", with_point}}));
  });
}

}  // namespace axisc::validator
