#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

#include <algorithm>

namespace axisc::validator {
namespace {

/// The number that was meant; empty where that is not obvious: an integer has no decimals.
std::string repaired(std::string value, Reading const& reading) {
  std::replace(value.begin(), value.end(), ',', '.');
  if (!is_complete_number(value)) return {};
  bool const is_real = !reading.row_known() || reading.row->type == schema::DataType::real64;
  if (is_real) return value;
  std::size_t const point = value.find('.');
  bool const is_whole = value.find_first_not_of('0', point + 1) == std::string::npos;
  return is_whole ? value.substr(0, point) : std::string{};
}

}  // namespace

void checks::decimal_comma(ListContext const& context, Report& report) {
  for_each_doubtful(context.list, [&](grammar::Assignment const& assignment, Reading const& reading) {
    if (reading.status != ReadingStatus::decimal_comma) return;
    std::string const value = context.source.utf8(assignment.value);
    Finding& finding = add_at(context, report, assignment, reading, assignment.value,
                              message(Text::ax1005, {{"value", value}}));
    set_reaction(finding, Text::ax1005_reaction);
    std::string const number = repaired(value, reading);
    if (number.empty()) return;
    finding.fix = replace_by(place_of(context, assignment.value), number,
                             message(Text::ax1005_fix, {{"replacement", number}}));
  });
}

}  // namespace axisc::validator
