#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/helpers.hpp"

#include <cmath>

namespace axisc::validator::checks {
namespace {

Text headline(schema::Parameter const& parameter) {
  if (parameter.type == schema::DataType::boolean) return Text::ax2003_boolean;
  if (parameter.type == schema::DataType::real64) return Text::ax2003_real;
  return schema::is_integer(parameter.type) ? Text::ax2003_integer : Text::ax2003_symbol;
}

void describe(Finding& finding, Line const& line) {
  schema::Parameter const& parameter = *line.reading().row;
  std::string const value = line.text(line.reading().text);
  finding.message =
      message_of(headline(parameter), Argument{"parameter", line.name()}, Argument{"value", value});
  if (!schema::is_number(parameter.type)) return;
  if (line.assignment().kind != grammar::ValueKind::real) {
    set_reaction(finding, Text::parameter_no_number, {}, "0");
    finding.control->message = "1001138";
    return;
  }
  double const real = schema::read_real(value).number;
  if (real != std::floor(real) || std::abs(real) >= 1e15) return;
  std::string const whole = format_exact(real);
  finding.fix = replace_by(line.place(line.reading().text), whole,
                           message(Text::parameter_fix, {{"replacement", whole}}));
}

void wrong_type(ListContext const& context, Report& report) {
  for_each_doubtful(context, [&](Line const& line) {
    if (line.reading().status != ReadingStatus::wrong_type) return;
    report_line<describe>(report, line, line.reading().text);
  });
}

}  // namespace

extern constinit Rule const ax2003{
    .code = Code{2003},
    .name = "wrong-type",
    .precedence = Precedence::before_family,
    .check = wrong_type,
};

}  // namespace axisc::validator::checks
