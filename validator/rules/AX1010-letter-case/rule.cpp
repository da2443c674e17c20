#include "validator/engine/rule.hpp"

#include "diagnostics/ascii.hpp"
#include "validator/rules/helpers.hpp"

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
void describe(Finding& finding, std::string written, std::string const& expected) {
  finding.message =
      message_of(says::headline, Argument{"written", std::move(written)}, Argument{"expected", expected});
  set_reaction(finding, says::reaction);
  finding.fix = replace_by(*finding.place, expected, message_of(says::fix, Argument{"expected", expected}),
                           FixSafety::safe);
}

void describe_name(Finding& finding, Line const& line) {
  describe(finding, line.name(), schema::slot_name(*line.line_value().row, line.line_value().slot));
}

void describe_symbol(Finding& finding, Line const& line) {
  std::string const written = line.text(line.line_value().text);
  describe(finding, written, ascii::upper_case(written));
}

void letter_case(ListContext const& context, Report& report) {
  for_each_doubtful(context, [&](Line const& line) {
    LineValue const& line_value = line.line_value();
    if (line_value.known() && line_value.name_folded) {
      report_line<describe_name>(report, line, line.assignment().name);
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
