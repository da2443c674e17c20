#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

#include <algorithm>

namespace axisc::validator {
namespace {

constexpr std::string_view end_marker = "Ende";

void describe(Finding& finding, std::string const& expected) {
  set_reaction(finding, Text::ax1010_reaction);
  finding.fix = replace_by(*finding.place, expected, message(Text::ax1010_fix, {{"expected", expected}}),
                           FixSafety::safe);
}

Message headline(std::string written, std::string expected) {
  return message(Text::ax1010, {{"written", std::move(written)}, {"expected", std::move(expected)}});
}

std::string upper_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return text;
}

}  // namespace

void checks::letter_case(ListContext const& context, Report& report) {
  for_each_doubtful(context.list, [&](grammar::Assignment const& assignment, Reading const& reading) {
    if (reading.known() && reading.name_folded) {
      std::string const expected = schema::slot_name(*reading.row, reading.slot);
      describe(add_at(context, report, assignment, reading, assignment.name,
                      headline(written_name(context, assignment), expected)),
               expected);
    }
    if (reading.symbol_folded && reading.status == ReadingStatus::value) {
      std::string const written = context.source.utf8(reading.text);
      std::string const expected = upper_case(written);
      describe(add_at(context, report, assignment, reading, reading.text, headline(written, expected)),
               expected);
    }
  });
  if (auto const& marker = context.list.tree.end_marker) {
    std::string_view const written = context.source.slice(*marker);
    if (written == end_marker) return;
    Message const text = headline(std::string(written), std::string(end_marker));
    describe(report.add(place_of(context, *marker), text), std::string(end_marker));
  }
}

}  // namespace axisc::validator
