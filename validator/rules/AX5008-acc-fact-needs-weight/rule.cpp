#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/program_helpers.hpp"

namespace axisc::validator::checks::ax5008::says {

constexpr Sentence headline{
    "`ACC_FACT` needs a valid P-AXIS-00013 (`getriebe[0].dynamik.a_trans_weight`) in every axis: {axes}",
    "`ACC_FACT` braucht in jeder Achse ein gültiges P-AXIS-00013 (`getriebe[0].dynamik.a_trans_weight`): "
    "{axes}"};
constexpr Sentence limit{
    "P-AXIS-00013: 1 ≤ a_trans_weight ≤ 1000 (0.1 %); 0 or unset is not valid",
    "P-AXIS-00013: 1 ≤ a_trans_weight ≤ 1000 (0,1 %); 0 oder nicht gesetzt ist ungültig"};
constexpr Sentence value_here{"axis {axis} has {value} here", "die Achse {axis} hat hier {value}"};
constexpr Sentence help{"set it to 1 to 1000 in these axes, or remove `ACC_FACT`",
                        "es in diesen Achsen auf 1 bis 1000 setzen, oder `ACC_FACT` entfernen"};

}  // namespace axisc::validator::checks::ax5008::says

namespace axisc::validator::checks::ax5008 {
namespace {

/// P-AXIS-00013 of the first gear.
constexpr std::string_view weight = "getriebe[].dynamik.a_trans_weight";
constexpr double largest_weight = 1000;

/// The values of the command's ACC_FACT, or the keyword if it has none.
std::vector<Span> acceleration_factors(ProgramContext const& context) {
  std::vector<Span> spans;
  for (grammar::NcCommand const& command : context.program.tree.commands) {
    grammar::Keyword const* const keyword = find_keyword(command, context.text, "ACC_FACT");
    if (keyword != nullptr) spans.push_back(keyword->value.empty() ? keyword->name : keyword->value);
  }
  return spans;
}

void acc_fact_needs_weight(ProgramContext const& context, Report& report) {
  std::vector<Span> const spans = acceleration_factors(context);
  if (spans.empty()) return;
  auto const axes = axes_where(context, [](EffectiveValues const& values) {
    EffectiveValue const& value = values.at(weight);
    return !value.unusable && !(value.value.number >= 1 && value.value.number <= largest_weight);
  });
  if (axes.empty()) return;
  Finding& finding =
      report_at_last(context, report, spans, message(says::headline, {{"axes", names_of(axes)}}));
  set_axis(finding, axes);
  finding.notes.push_back(message(says::limit));
  finding.help.push_back(message(says::help));
  for (LoadedAxis const* const axis : axes) {
    EffectiveValue const& value = axis->merged.values.at(weight);
    if (!value.value_place()) continue;
    finding.related.push_back(
        {.place = *value.value_place(),
         .message =
             message(says::value_here, {{"axis", axis->name}, {"value", exact_number(value.value.number)}})});
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters = "getriebe[].dynamik.a_trans_weight",
    .check = acc_fact_needs_weight,
};

}  // namespace axisc::validator::checks::ax5008
