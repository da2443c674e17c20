#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

namespace axisc::validator {
namespace {

/// 007 as 7, -0.5 stays: the number without the zeros that the control rejects.
std::string without_leading_zeros(std::string const& value) {
  std::size_t const sign = value.find_first_of("+-") == 0 ? 1 : 0;
  std::size_t const first = value.find_first_not_of('0', sign);
  if (first == std::string::npos) return value.substr(0, sign) + "0";
  bool const needs_zero = value[first] < '0' || value[first] > '9';
  return value.substr(0, sign) + (needs_zero ? "0" : "") + value.substr(first);
}

}  // namespace

void checks::malformed_number(ListContext const& context, Report& report) {
  for_each_doubtful(context.list, [&](grammar::Assignment const& assignment, Reading const& reading) {
    if (reading.status != ReadingStatus::malformed_number) return;
    std::string const value = context.source.utf8(assignment.value);
    auto const add = [&](Text text, std::string control, Text reaction, std::string result) -> Finding& {
      Finding& finding = add_at(context, report, assignment, reading, assignment.value,
                                message_of(text, Argument{"value", value}));
      set_reaction(finding, reaction, {}, std::move(result));
      finding.control->message = std::move(control);
      return finding;
    };
    switch (reading.number) {
      case NumberStatus::leading_zero: {
        Finding& finding = add(Text::ax1006_leading_zero, "1022", Text::ax1006_leading_zero_reaction, "");
        std::string const shorter = without_leading_zeros(value);
        if (!is_complete_number(shorter)) return;
        finding.fix = replace_by(place_of(context, assignment.value), shorter,
                                 message(Text::ax1006_fix, {{"replacement", shorter}}));
        return;
      }
      case NumberStatus::exponent_too_big:
        add(Text::ax1006_exponent, "1027", Text::ax1006_exponent_reaction, "");
        return;
      case NumberStatus::good:
      case NumberStatus::not_a_number:
      case NumberStatus::out_of_data_range:
        break;
    }
    add(Text::ax1006, "1001138", Text::ax1006_reaction, "0");
  });
}

}  // namespace axisc::validator
