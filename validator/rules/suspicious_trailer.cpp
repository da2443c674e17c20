#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

#include <algorithm>

namespace axisc::validator {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// P-AXIS-00212 or P-AXIS-00212.0.
bool is_reference(std::string_view word) {
  constexpr std::string_view prefix = "P-AXIS-";
  if (word.substr(0, prefix.size()) != prefix) return false;
  word.remove_prefix(prefix.size());
  std::string_view const number = word.substr(0, word.find('.'));
  std::string_view const index = word.substr(std::min(number.size() + 1, word.size()));
  bool const has_index = number.size() < word.size();
  return !number.empty() && std::all_of(number.begin(), number.end(), is_digit) &&
         has_index == !index.empty() && std::all_of(index.begin(), index.end(), is_digit);
}

bool is_upper_case(std::string_view word) {
  return std::none_of(word.begin(), word.end(), [](char c) { return c >= 'a' && c <= 'z'; });
}

bool looks_like_value(schema::Catalogue const& catalogue, std::string_view word) {
  return is_complete_number(word) || is_reference(word) ||
         (is_upper_case(word) && catalogue.is_symbol_of_any_parameter(word));
}

/// Behind numbers, booleans and references the control reads over everything; behind words AX1009 looks.
bool ends_at_blank(grammar::Assignment const& assignment, Reading const& reading) {
  using grammar::ValueKind;
  if (reading.status == ReadingStatus::reference) return true;
  bool const usable = reading.status == ReadingStatus::value || reading.status == ReadingStatus::not_judged ||
                      reading.status == ReadingStatus::out_of_data_range;
  if (!usable) return false;
  if (reading.row_known()) {
    schema::Parameter const& parameter = *reading.row;
    if (parameter.type == schema::DataType::boolean) return true;
    if (parameter.type == schema::DataType::string && !parameter.is_enumeration()) return false;
  }
  return assignment.kind == ValueKind::integer || assignment.kind == ValueKind::hexadecimal ||
         assignment.kind == ValueKind::real || assignment.kind == ValueKind::reference;
}

}  // namespace

void checks::suspicious_trailer(ListContext const& context, Report& report) {
  for_each_doubtful(context.list, [&](grammar::Assignment const& assignment, Reading const& reading) {
    if (assignment.trailer_kind != grammar::TrailerKind::text || !ends_at_blank(assignment, reading)) return;
    std::string_view const trailer = context.source.slice(assignment.trailer);
    std::string_view const word = trailer.substr(0, trailer.find_first_of(" \t("));
    if (!looks_like_value(context.list.catalogue, word)) return;
    Span const span{.begin = assignment.trailer.begin,
                    .end = assignment.trailer.begin + static_cast<std::uint32_t>(word.size())};
    Finding& finding = add_at(context, report, assignment, reading, span,
                              message(Text::ax1007, {{"text", std::string(word)}}));
    set_reaction(finding, Text::ax1007_reaction, {}, context.source.utf8(assignment.value));
    finding.help.push_back(message(Text::ax1007_help));
    Span const before{.begin = span.begin, .end = span.begin};
    finding.fix = replace_by(place_of(context, before), "( ", message(Text::ax1007_fix), FixSafety::safe);
  });
}

}  // namespace axisc::validator
