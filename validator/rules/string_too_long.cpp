#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

#include <algorithm>

namespace axisc::validator {
namespace {

std::size_t characters(std::string_view utf8) {
  return static_cast<std::size_t>(std::count_if(
      utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace

void checks::string_too_long(ListContext const& context, Report& report) {
  for_each_doubtful(context.list, [&](grammar::Assignment const& assignment, Reading const& reading) {
    if (!reading.row_known() || reading.status != ReadingStatus::value) return;
    schema::Parameter const& parameter = *reading.row;
    if (parameter.max_length == 0 || reading.value.text.size() <= parameter.max_length) return;
    std::size_t const length = characters(reading.value.text);
    if (length <= parameter.max_length) return;
    Finding& finding = add_at(context, report, assignment, reading, reading.text,
                              message(Text::ax2008, {{"length", std::to_string(length)},
                                                     {"parameter", written_name(context, assignment)},
                                                     {"limit", std::to_string(parameter.max_length)}}));
    set_reaction(finding, Text::ax2008_reaction);
  });
}

}  // namespace axisc::validator
