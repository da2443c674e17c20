#include "validator/engine/rule.hpp"

#include "diagnostics/ascii.hpp"
#include "diagnostics/format_number.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/rules/thousands.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace axisc::validator::checks::ax2003::says {

constexpr Sentence parameter_no_number{"it finds no number", "sie findet keine Zahl"};

constexpr Sentence no_switch{"it finds no truth value", "sie findet keinen Wahrheitswert"};
constexpr Sentence integer{"`{parameter}` needs a whole number, not `{value}`",
                           "`{parameter}` braucht eine ganze Zahl, nicht `{value}`"};
constexpr Sentence real{"`{parameter}` needs a number, not `{value}`",
                        "`{parameter}` braucht eine Zahl, nicht `{value}`"};
constexpr Sentence boolean{"`{parameter}` is a switch: 0 or 1, not `{value}`",
                           "`{parameter}` ist ein Schalter: 0 oder 1, nicht `{value}`"};
constexpr Sentence symbol{"`{parameter}` needs a symbol or its number, not `{value}`",
                          "`{parameter}` braucht ein Symbol oder dessen Nummer, nicht `{value}`"};

}  // namespace axisc::validator::checks::ax2003::says

namespace axisc::validator::checks::ax2003 {
namespace {

SentenceRef headline(schema::Parameter const& parameter) {
  if (parameter.type == schema::DataType::boolean) return says::boolean;
  if (parameter.type == schema::DataType::real64) return says::real;
  return schema::is_integer(parameter.type) ? says::integer : says::symbol;
}

// Message numbers of the control.
constexpr std::string_view no_boolean = "1019";
constexpr std::string_view no_number = "1001138";

/// The meaning of a word for a switch, in English or German; empty for other words.
std::string_view switch_meant(std::string_view word) {
  constexpr std::array<std::string_view, 6> on{"ON", "YES", "EIN", "AN", "JA", "WAHR"};
  constexpr std::array<std::string_view, 5> off{"OFF", "NO", "AUS", "NEIN", "FALSCH"};
  auto const is_word = [word](std::string_view known) { return ascii::equal_ignoring_case(word, known); };
  if (std::any_of(on.begin(), on.end(), is_word)) return "1";
  return std::any_of(off.begin(), off.end(), is_word) ? "0" : "";
}

/// Where its numbers have names, the value was perhaps meant as one of them.
void name_numbers(Finding& finding, Line const& line, std::string const& value) {
  schema::Parameter const& parameter = *line.line_value().row;
  if (parameter.number_names.empty()) return;
  finding.notes.push_back(
      message_of(validator::says::parameter_values, Argument{"values", allowed_values(parameter)}));
  auto const named = std::find_if(parameter.number_names.begin(), parameter.number_names.end(),
                                  [&](schema::Symbol const& symbol) {
                                    std::string_view const start = symbol.word.substr(0, value.size());
                                    return value.size() > 2 && ascii::equal_ignoring_case(start, value);
                                  });
  if (named == parameter.number_names.end()) return;
  std::string const number = std::to_string(named->number.value_or(0));
  finding.fix = replace_by(line.place(line.line_value().text), number,
                           message(validator::says::parameter_fix, {{"replacement", number}}));
}

void describe(Finding& finding, Line const& line) {
  schema::Parameter const& parameter = *line.line_value().row;
  std::string const value = line.text(line.line_value().text);
  finding.message =
      message_of(headline(parameter), Argument{"parameter", line.name()}, Argument{"value", value});
  if (parameter.type == schema::DataType::boolean) {
    set_reaction(finding, says::no_switch);
    finding.control->message = no_boolean;
    if (std::string const number(switch_meant(value)); !number.empty()) {
      finding.fix = replace_by(line.place(line.line_value().text), number,
                               message(validator::says::parameter_fix, {{"replacement", number}}));
    }
  }
  if (!schema::is_number(parameter.type)) return;
  if (line.assignment().kind != grammar::ValueKind::real) {
    set_reaction(finding, says::parameter_no_number, {}, "0");
    finding.control->message = no_number;
    name_numbers(finding, line, value);
    return;
  }
  if (describe_thousands(finding, value)) return;
  schema::NumberReading const line_value = schema::read_real(value);
  double const real = line_value.number;
  if (line_value.status != schema::NumberStatus::good) return;
  if (real != std::floor(real) || std::abs(real) >= 1e15) return;
  std::string const whole = format_exact(real);
  finding.fix = replace_by(line.place(line.line_value().text), whole,
                           message(validator::says::parameter_fix, {{"replacement", whole}}));
}

void wrong_type(ListContext const& context, Report& report) {
  for_each_doubtful(context, [&](Line const& line) {
    if (line.line_value().status != ReadingStatus::wrong_type) return;
    report_line<describe>(report, line, line.line_value().text);
  });
}

}  // namespace

extern constinit Rule const rule{
    .about = [](schema::Parameter const&) { return true; },
    .precedence = Precedence::before_family,
    .check = wrong_type,
};

}  // namespace axisc::validator::checks::ax2003
