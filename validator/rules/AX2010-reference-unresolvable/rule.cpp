#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/reference_words.hpp"

#include <cstdint>

namespace axisc::validator::checks::ax2010::says {

constexpr Sentence headline{"there is no parameter {p_axis}", "einen Parameter {p_axis} gibt es nicht"};
constexpr Sentence no_value{
    "`{name}` ({p_axis}) has no value: no list sets it, and it has no default",
    "`{name}` ({p_axis}) hat keinen Wert: keine Liste setzt ihn, und er hat keinen Standardwert"};

constexpr Sentence overwritten{"it cannot resolve the reference; a later line applies",
                               "sie kann den Verweis nicht auflösen; es gilt eine spätere Zeile"};
constexpr Sentence help{"correct the number, or write the value itself",
                        "die Nummer berichtigen, oder den Wert selbst schreiben"};

}  // namespace axisc::validator::checks::ax2010::says

namespace axisc::validator::checks::ax2010 {
namespace {

bool exists(AxisContext const& context, std::uint32_t p_axis) {
  if (p_axis == 0 || p_axis > UINT16_MAX) return false;
  return !context.values.catalogue().find_number(static_cast<std::uint16_t>(p_axis)).empty();
}

/// References to nothing in lines that a later one of their list overwrites, which resolving never sees.
void report_overwritten(AxisContext const& context, LoadedList const& list, Report& report) {
  for (std::uint32_t const number : list.line_values.without_value()) {
    LineValue const line_value = list.line_values[number];
    if (!line_value.known() || line_value.status != ReadingStatus::reference) continue;
    bool const applies = list.line_values.last_of(line_value.slot) == number + 1;
    if (applies || exists(context, line_value.reference.p_axis)) continue;
    ReferenceProblem const problem{
        .slot = line_value.slot, .p_axis = line_value.reference.p_axis, .target = {}, .circle = {}};
    Finding& finding = report.add(Place{.source = list.source, .span = list.tree.assignments[number].value},
                                  context.values.row(line_value.slot), line_value.slot,
                                  message(says::headline, {{"p_axis", named(problem)}}));
    set_reaction(finding, says::overwritten);
    finding.help.push_back(message(says::help));
  }
}

void reference_unresolvable(AxisContext const& context, Report& report) {
  for_each_problem(context, ReferenceTrouble::unresolvable,
                   [&](ReferenceProblem const& problem, EffectiveValue const& value) {
                     Message const text =
                         problem.target
                             ? message(says::no_value, {{"name", name_of(context, *problem.target)},
                                                        {"p_axis", named(problem)}})
                             : message(says::headline, {{"p_axis", named(problem)}});
                     Finding& finding = report.add(value, text);
                     keep_earlier(context, finding, value);
                     finding.help.push_back(message(says::help));
                   });
  for (LoadedList const* const list : lists_of(context)) {
    if (list != nullptr) report_overwritten(context, *list, report);
  }
}

}  // namespace

extern constinit Rule const rule{
    .control = "2052",
    .check = reference_unresolvable,
};

}  // namespace axisc::validator::checks::ax2010
