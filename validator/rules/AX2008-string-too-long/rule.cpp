#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax2008::says {

constexpr Sentence headline{"the text has {length} characters, `{parameter}` holds {limit}",
                            "der Text hat {length} Zeichen, `{parameter}` fasst {limit}"};
constexpr Sentence reaction{"it reports the text as too long, start-up continues",
                            "sie meldet den Text als zu lang, der Hochlauf geht weiter"};
constexpr Sentence help{"shorten it to {limit} characters", "auf {limit} Zeichen kürzen"};

}  // namespace axisc::validator::checks::ax2008::says

namespace axisc::validator::checks::ax2008 {
namespace {

std::size_t characters(std::string_view utf8) {
  return static_cast<std::size_t>(std::count_if(
      utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

void describe(Finding& finding, Line const& line) {
  std::size_t const length = characters(line.line_value().value.text);
  finding.message = message(says::headline, {{"length", std::to_string(length)},
                                             {"parameter", line.name()},
                                             {"limit", std::to_string(line.line_value().row->max_length)}});
  set_reaction(finding, says::reaction);
  finding.help.push_back(message(says::help, {{"limit", std::to_string(line.line_value().row->max_length)}}));
}

void string_too_long(ListContext const& context, Report& report) {
  for_each_doubtful(context, [&](Line const& line) {
    LineValue const& line_value = line.line_value();
    if (!line_value.row_known() || line_value.status != ReadingStatus::value) return;
    std::size_t const most = line_value.row->max_length;
    if (most == 0 || line_value.value.text.size() <= most || characters(line_value.value.text) <= most) {
      return;
    }
    report_line<describe>(report, line, line_value.text);
  });
}

}  // namespace

extern constinit Rule const rule{
    .control = "2023",
    .about = [](schema::Parameter const& parameter) { return parameter.max_length > 0; },
    .check = string_too_long,
};

}  // namespace axisc::validator::checks::ax2008
