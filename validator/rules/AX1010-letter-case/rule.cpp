#include "validator/engine/rule.hpp"

#include "diagnostics/ascii.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/values/line_values.hpp"

#include <cstddef>
#include <unordered_set>

namespace axisc::validator::checks::ax1010::says {

constexpr Sentence headline{"`{written}` differs from `{expected}` in letter case",
                            "`{written}` weicht in der Groß- und Kleinschreibung von `{expected}` ab"};
constexpr Sentence reaction{"how it treats a different letter case is not documented",
                            "ihr Verhalten bei anderer Groß- und Kleinschreibung ist nicht dokumentiert"};
constexpr Sentence fix{"write `{expected}`", "`{expected}` schreiben"};

}  // namespace axisc::validator::checks::ax1010::says

namespace axisc::validator::checks::ax1010 {
namespace {

constexpr std::string_view end_marker = "Ende";

/// The place of `finding` is the text as written.
void describe(Finding& finding, std::string written, std::string const& expected,
              FixSafety safety = FixSafety::safe) {
  finding.message =
      message_of(says::headline, Argument{"written", std::move(written)}, Argument{"expected", expected});
  set_reaction(finding, says::reaction);
  finding.fix =
      replace_by(*finding.place, expected, message_of(says::fix, Argument{"expected", expected}), safety);
}

std::string proper_name(Line const& line) {
  return schema::slot_name(*line.line_value().row, line.line_value().slot);
}

void describe_name(Finding& finding, Line const& line) {
  describe(finding, line.name(), proper_name(line));
}

/// A control that ignores the name has another value now.
void describe_repeated_name(Finding& finding, Line const& line) {
  describe(finding, line.name(), proper_name(line), FixSafety::changes_behaviour);
}

void describe_symbol(Finding& finding, Line const& line) {
  std::string const written = line.text(line.line_value().text);
  describe(finding, written, ascii::upper_case(written));
}

/// The parameters that several lines set.
std::unordered_set<schema::Slot> repeated_parameters(LineValues const& values) {
  std::unordered_set<schema::Slot> repeated;
  if (!values.has_repetitions()) return repeated;
  std::unordered_set<schema::Slot> known;
  for (std::size_t i = 0; i < values.size(); ++i) {
    auto const slot = values.slot(i);
    if (slot && !known.insert(*slot).second) repeated.insert(*slot);
  }
  return repeated;
}

void letter_case(ListContext const& context, Report& report) {
  auto const repeated = repeated_parameters(context.list.line_values);
  for_each_doubtful(context, [&](Line const& line) {
    LineValue const& line_value = line.line_value();
    if (line_value.known() && line_value.name_folded) {
      if (repeated.contains(line_value.slot)) {
        report_line<describe_repeated_name>(report, line, line.assignment().name);
      } else {
        report_line<describe_name>(report, line, line.assignment().name);
      }
    }
    if (line_value.symbol_folded && line_value.status == ReadingStatus::value) {
      report_line<describe_symbol>(report, line, line_value.text);
    }
  });
  auto const& marker = context.list.tree.end_marker;
  if (!marker || context.source.slice(*marker) == end_marker) return;
  report.later(place_of(context, *marker), [&context](Finding& finding) {
    std::string_view const written = context.source.slice(finding.place->span);
    describe(finding, std::string(written), std::string(end_marker));
  });
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .check = letter_case,
};

}  // namespace axisc::validator::checks::ax1010
