#include "diagnostics/format_number.hpp"
#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

#include <cmath>

namespace axisc::validator {
namespace {

Text headline(schema::Parameter const& parameter) {
  if (parameter.type == schema::DataType::boolean) return Text::ax2003_boolean;
  if (parameter.type == schema::DataType::real64) return Text::ax2003_real;
  return schema::is_integer(parameter.type) ? Text::ax2003_integer : Text::ax2003_symbol;
}

}  // namespace

void checks::wrong_type(ListContext const& context, Report& report) {
  for_each_doubtful(context.list, [&](grammar::Assignment const& assignment, Reading const& reading) {
    if (reading.status != ReadingStatus::wrong_type) return;
    schema::Parameter const& parameter = *reading.row;
    std::string const value = context.source.utf8(reading.text);
    Finding& finding =
        add_at(context, report, assignment, reading, reading.text,
               message_of(headline(parameter), Argument{"parameter", written_name(context, assignment)},
                          Argument{"value", value}));
    bool const number = schema::is_integer(parameter.type) || parameter.type == schema::DataType::real64;
    if (number && assignment.kind != grammar::ValueKind::real) {
      set_reaction(finding, Text::parameter_no_number, {}, "0");
      finding.control->message = "1001138";
    }
    if (assignment.kind != grammar::ValueKind::real || !number) return;
    double const real = read_real(value).number;
    if (real != std::floor(real) || std::abs(real) >= 1e15) return;
    std::string const whole = format_exact(real);
    finding.fix = replace_by(place_of(context, reading.text), whole,
                             message(Text::parameter_fix, {{"replacement", whole}}));
  });
}

}  // namespace axisc::validator
