#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/values/line_values.hpp"

#include <cstdint>
#include <unordered_map>
#include <utility>

namespace axisc::validator::checks::ax2006::says {

constexpr Sentence headline{"`{parameter}` is set again in line {line}; the last value applies",
                            "`{parameter}` wird in Zeile {line} erneut gesetzt, es gilt der letzte Wert"};
constexpr Sentence related{"this value applies", "dieser Wert gilt"};
constexpr Sentence fix{"make the earlier one a comment", "die frühere Zuweisung zum Kommentar machen"};

}  // namespace axisc::validator::checks::ax2006::says

namespace axisc::validator::checks::ax2006 {
namespace {

/// The earlier of two lines that set one parameter.
void describe(Finding& finding, Line const& line, grammar::Assignment const& later) {
  name_parameter(finding, line);
  finding.message =
      message(says::headline, {{"parameter", line.name()}, {"line", std::to_string(later.line)}});
  finding.related.push_back({.place = line.place(later.value), .message = message(says::related)});
  // The last line applies, so the earlier one is ignored. As a comment, a line with a directive would apply
  // to the next line.
  grammar::Assignment const& assignment = line.assignment();
  SourceText const& source = line.context.source;
  if (source.slice(source.line_span(assignment.line)).find("axisc:") != std::string_view::npos) return;
  Span const at_name{.begin = assignment.name.begin, .end = assignment.name.begin};
  finding.fix = replace_by(line.place(at_name), "# ", message(says::fix), FixSafety::safe);
}

void duplicate_parameter(ListContext const& context, Report& report) {
  if (!context.list.line_values.has_repetitions()) return;
  std::unordered_map<schema::Slot, std::uint32_t> last;  // index + 1; 0: not set yet
  LineValues const& line_values = context.list.line_values;
  for (std::uint32_t i = 0; i < line_values.size(); ++i) {
    // A broken line sets nothing, so it repeats nothing.
    LineValue const line_value = line_values[i];
    if (!line_value.usable()) continue;
    std::uint32_t const before = std::exchange(last[line_value.slot], i + 1);
    if (before == 0) continue;
    std::uint32_t const earlier = before - 1;
    Place const place = place_of(context, context.list.tree.assignments[earlier].value);
    report.later(place, [&context, earlier, i](Finding& finding) {
      describe(finding, {context, earlier}, context.list.tree.assignments[i]);
    });
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .precedence = Precedence::after_text,
    .check = duplicate_parameter,
};

}  // namespace axisc::validator::checks::ax2006
