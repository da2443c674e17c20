#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax1005::says {

constexpr Sentence headline{"`{value}` has a decimal comma", "`{value}` hat ein Dezimalkomma"};
constexpr Sentence reaction{"it expects a decimal point and would read a different number",
                            "sie erwartet einen Dezimalpunkt und würde eine andere Zahl lesen"};
constexpr Sentence fix{"write `{replacement}`", "`{replacement}` schreiben"};
constexpr Sentence whole{"the parameter takes whole numbers only", "der Parameter nimmt nur ganze Zahlen an"};

}  // namespace axisc::validator::checks::ax1005::says

namespace axisc::validator::checks::ax1005 {
namespace {

/// The intended number; empty if it is not obvious: an integer has no decimals.
std::string repaired(std::string value, LineValue const& line_value) {
  std::replace(value.begin(), value.end(), ',', '.');
  if (!schema::is_complete_number(value)) return {};
  bool const is_real = !line_value.row_known() || line_value.row->type == schema::DataType::real64;
  if (is_real) return value;
  std::size_t const point = value.find('.');
  bool const is_whole = value.find_first_not_of('0', point + 1) == std::string::npos;
  return is_whole ? value.substr(0, point) : std::string{};
}

void describe(Finding& finding, Line const& line) {
  Span const written = line.assignment().value;
  std::string const value = line.text(written);
  finding.message = message_of(says::headline, Argument{"value", value});
  set_reaction(finding, says::reaction);
  std::string const number = repaired(value, line.line_value());
  if (number.empty()) {
    finding.help.push_back(message(says::whole));
    return;
  }
  finding.fix =
      replace_by(line.place(written), number, message_of(says::fix, Argument{"replacement", number}));
}

void decimal_comma(ListContext const& context, Report& report) {
  for_each_doubtful(context, [&](Line const& line) {
    if (line.line_value().status != ReadingStatus::decimal_comma) return;
    report_line<describe>(report, line, line.assignment().value);
  });
}

}  // namespace

extern constinit Rule const rule{
    .check = decimal_comma,
};

}  // namespace axisc::validator::checks::ax1005
