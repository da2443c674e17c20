#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/values/line_values.hpp"

#include <cstdint>
#include <optional>
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

/// It names a parameter that there is not, so the control keeps what it has (AX2010).
bool refers_to_nothing(ListContext const& context, LineValue const& value) {
  if (value.status != ReadingStatus::reference) return false;
  auto const number = static_cast<std::uint16_t>(value.reference.p_axis);
  return number != value.reference.p_axis || context.list.catalogue.find_number(number).empty();
}

bool is_plain(LineValue const& value) {
  return value.status == ReadingStatus::value && !value.name_folded;
}

/// None where the later line may not apply. Two different values are evidence of a mistake.
std::optional<FixSafety> safety(LineValue const& earlier, LineValue const& later) {
  if (later.status == ReadingStatus::reference) return std::nullopt;
  bool const is_same = is_plain(earlier) && is_plain(later) && earlier.value.number == later.value.number &&
                       earlier.value.text == later.value.text;
  return is_same ? FixSafety::safe : FixSafety::changes_behaviour;
}

/// The earlier of two lines that set one parameter.
void describe(Finding& finding, Line const& line, std::uint32_t number_of_later) {
  grammar::Assignment const& later = line.context.list.tree.assignments[number_of_later];
  name_parameter(finding, line);
  finding.message =
      message(says::headline, {{"parameter", line.name()}, {"line", std::to_string(later.line)}});
  finding.related.push_back({.place = line.place(later.value), .message = message(says::related)});
  // As a comment, a line with a directive would apply to the next line.
  grammar::Assignment const& assignment = line.assignment();
  SourceText const& source = line.context.source;
  if (source.slice(source.line_span(assignment.line)).find("axisc:") != std::string_view::npos) return;
  LineValues const& values = line.context.list.line_values;
  auto const how = safety(values[line.number], values[number_of_later]);
  if (!how) return;
  Span const at_name{.begin = assignment.name.begin, .end = assignment.name.begin};
  finding.fix = replace_by(line.place(at_name), "# ", message(says::fix), *how);
}

void duplicate_parameter(ListContext const& context, Report& report) {
  if (!context.list.line_values.has_repetitions()) return;
  std::unordered_map<schema::Slot, std::uint32_t> last;  // index + 1; 0: not set yet
  LineValues const& line_values = context.list.line_values;
  for (std::uint32_t i = 0; i < line_values.size(); ++i) {
    // A broken line sets nothing, so it repeats nothing.
    LineValue const line_value = line_values[i];
    if (!line_value.usable() || refers_to_nothing(context, line_value)) continue;
    std::uint32_t const before = std::exchange(last[line_value.slot], i + 1);
    if (before == 0) continue;
    std::uint32_t const earlier = before - 1;
    Place const place = place_of(context, context.list.tree.assignments[earlier].value);
    report.later(place, [&context, earlier, i](Finding& finding) {
      describe(finding, {context, earlier}, i);
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
