#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/thousands.hpp"
#include "validator/views/written_unit.hpp"

namespace axisc::validator::checks::ax1006::says {

constexpr Sentence headline{"`{value}` is not a number", "`{value}` ist keine Zahl"};
constexpr Sentence leading_zero{"`{value}` begins with a zero", "`{value}` beginnt mit einer Null"};
constexpr Sentence exponent{"`{value}` is too large for a number", "`{value}` ist zu groß für eine Zahl"};
constexpr Sentence reaction{"it finds no number", "sie findet keine Zahl"};
constexpr Sentence leading_zero_reaction{"it rejects numbers with a leading zero",
                                         "sie weist Zahlen mit führender Null zurück"};
constexpr Sentence exponent_reaction{"it rejects the exponent", "sie weist den Exponenten zurück"};
constexpr Sentence blank{"insert a blank before `(`", "ein Leerzeichen vor `(` einfügen"};
constexpr Sentence fix{"write `{replacement}`", "`{replacement}` schreiben"};
constexpr Sentence help{"write a decimal number such as `40` or `0.5`, or a hexadecimal one such as `0x1F`",
                        "eine Dezimalzahl wie `40` oder `0.5` schreiben, oder eine hexadezimale wie `0x1F`"};

}  // namespace axisc::validator::checks::ax1006::says

namespace axisc::validator::checks::ax1006 {
namespace {

/// 007 as 7, -0.5 stays: the number without the zeros that the control rejects.
std::string without_leading_zeros(std::string const& value) {
  std::size_t const sign = value.find_first_of("+-") == 0 ? 1 : 0;
  std::size_t const first = value.find_first_not_of('0', sign);
  if (first == std::string::npos) return value.substr(0, sign) + "0";
  bool const needs_zero = value[first] < '0' || value[first] > '9';
  return value.substr(0, sign) + (needs_zero ? "0" : "") + value.substr(first);
}

/// The control's reaction to one kind of malformed number.
struct Trouble {
  SentenceRef headline;
  SentenceRef reaction;
  std::string_view control;  ///< instead of the row's number
  std::string_view result;
};

Trouble trouble_of(schema::NumberStatus status) {
  switch (status) {
    case schema::NumberStatus::leading_zero:
      return {.headline = says::leading_zero,
              .reaction = says::leading_zero_reaction,
              .control = "1022",
              .result = ""};
    case schema::NumberStatus::exponent_too_big:
      return {
          .headline = says::exponent, .reaction = says::exponent_reaction, .control = "1027", .result = ""};
    case schema::NumberStatus::good:
    case schema::NumberStatus::not_a_number:
    case schema::NumberStatus::out_of_data_range: break;
  }
  return {.headline = says::headline, .reaction = says::reaction, .control = "", .result = "0"};
}

/// `40Hz` as 40, `10ms` as the number of the parameter's unit; empty for other texts.
std::string without_unit(Line const& line, std::string_view value) {
  std::size_t size = value.size();
  while (size > 0 && !schema::is_complete_number(value.substr(0, size))) --size;
  schema::Parameter const* const row = line.line_value().row;
  if (size == 0 || row == nullptr) return {};
  for (std::string_view const unit : {row->unit_translatory, row->unit_rotary}) {
    auto const ratio = unit_ratio(value.substr(size), unit);
    if (!ratio) continue;
    double const number = schema::read_real(value.substr(0, size)).number;
    return converted_number(number, *ratio, schema::is_integer(row->type));
  }
  return {};
}

void describe(Finding& finding, Line const& line) {
  std::string const value = line.text(line.assignment().value);
  // A hexadecimal number has neither sign nor exponent.
  bool const signed_hexadecimal = value.find("0x") == 1 || value.find("0X") == 1;
  schema::NumberStatus const status =
      signed_hexadecimal ? schema::NumberStatus::not_a_number : line.line_value().number;
  Trouble const trouble = trouble_of(status);
  finding.message = message_of(trouble.headline, Argument{"value", value});
  set_reaction(finding, trouble.reaction, {}, std::string(trouble.result));
  if (!trouble.control.empty()) finding.control->message = trouble.control;
  if (describe_thousands(finding, value)) return;
  if (std::size_t const comment = value.find('('); comment != std::string::npos) {
    if (!schema::is_complete_number(std::string_view(value).substr(0, comment))) return;
    std::uint32_t const at = line.assignment().value.begin + static_cast<std::uint32_t>(comment);
    finding.fix = replace_by(line.place({.begin = at, .end = at}), " ", message(says::blank));
    return;
  }
  std::string const shorter =
      status == schema::NumberStatus::leading_zero ? without_leading_zeros(value) : without_unit(line, value);
  if (!schema::is_complete_number(shorter)) {
    finding.help.push_back(message(says::help));
    return;
  }
  finding.fix = replace_by(line.place(line.assignment().value), shorter,
                           message(says::fix, {{"replacement", shorter}}));
}

void malformed_number(ListContext const& context, Report& report) {
  for_each_doubtful(context, [&](Line const& line) {
    if (line.line_value().status != ReadingStatus::malformed_number) return;
    report_line<describe>(report, line, line.assignment().value);
  });
}

}  // namespace

extern constinit Rule const rule{
    .control = "1001138",
    .check = malformed_number,
};

}  // namespace axisc::validator::checks::ax1006
