#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/rules/thousands.hpp"

#include <cmath>

namespace axisc::validator::says {

constexpr Sentence parameter_no_number{"it finds no number", "sie findet keine Zahl"};

constexpr Sentence integer{"`{parameter}` needs a whole number, not `{value}`",
                           "`{parameter}` braucht eine ganze Zahl, nicht `{value}`"};
constexpr Sentence real{"`{parameter}` needs a number, not `{value}`",
                        "`{parameter}` braucht eine Zahl, nicht `{value}`"};
constexpr Sentence boolean{"`{parameter}` is a switch: 0 or 1, not `{value}`",
                           "`{parameter}` ist ein Schalter: 0 oder 1, nicht `{value}`"};
constexpr Sentence symbol{"`{parameter}` needs a symbol or its number, not `{value}`",
                          "`{parameter}` braucht ein Symbol oder dessen Nummer, nicht `{value}`"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
namespace {

SentenceRef headline(schema::Parameter const& parameter) {
  if (parameter.type == schema::DataType::boolean) return says::boolean;
  if (parameter.type == schema::DataType::real64) return says::real;
  return schema::is_integer(parameter.type) ? says::integer : says::symbol;
}

void describe(Finding& finding, Line const& line) {
  schema::Parameter const& parameter = *line.reading().row;
  std::string const value = line.text(line.reading().text);
  finding.message =
      message_of(headline(parameter), Argument{"parameter", line.name()}, Argument{"value", value});
  if (!schema::is_number(parameter.type)) return;
  if (line.assignment().kind != grammar::ValueKind::real) {
    set_reaction(finding, says::parameter_no_number, {}, "0");
    finding.control->message = "1001138";
    return;
  }
  if (describe_thousands(finding, value)) return;
  double const real = schema::read_real(value).number;
  if (real != std::floor(real) || std::abs(real) >= 1e15) return;
  std::string const whole = format_exact(real);
  finding.fix = replace_by(line.place(line.reading().text), whole,
                           message(says::parameter_fix, {{"replacement", whole}}));
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
    .about = [](schema::Parameter const&) { return true; },
    .precedence = Precedence::before_family,
    .check = wrong_type,
};

}  // namespace axisc::validator::checks
