// AX3032, AX3033 and AX3035: limits that take the effect away.
#include "validator/position_control_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/position_control_checks.hpp"

#include <algorithm>

namespace axisc::validator::checks {
namespace {

constexpr double largest_weight = 7;

}  // namespace

void ipc_weight_limited(AxisContext const& axis, Report& report) {
  for (StageView const& stage : axis.position_control.active_stages()) {
    EffectiveValue const& numerator = stage.weight_numerator;
    EffectiveValue const& denominator = stage.weight_denominator;
    if (numerator.unusable || denominator.unusable || !(denominator.value.number > 0)) continue;
    double const weight = numerator.value.number / denominator.value.number;
    if (weight <= largest_weight) continue;
    Finding& finding = report.add(numerator, {Text::ax3032, {{"weight", number(weight)}}});
    finding.label = Message{Text::ax3032_label,
                            {{"numerator", number(numerator.value.number)},
                             {"denominator", number(denominator.value.number)},
                             {"weight", number(weight)}}};
    finding.notes.push_back({Text::ax3032_limit,
                             {{"numerator", parameter_number(numerator)},
                              {"denominator", parameter_number(denominator)},
                              {"limit", number(largest_weight)}}});
    if (denominator.value_place()) {
      finding.related.push_back({*denominator.value_place(), {Text::ax3032_denominator_here, {}}});
    }
    react(finding, "70605", {Text::ax3032_reaction, {}}, number(largest_weight));
  }
}

void ipc_without_limit(AxisContext const& axis, Report& report) {
  PositionControlView const& view = axis.position_control;
  if (!view.enabled() || view.limit.unusable || view.limit.value.number != 0) return;
  Finding& finding = report.add(view.limit.set() ? view.limit : view.enable, {Text::ax3033, {}});
  finding.notes.push_back({Text::ax3033_limit, {{"p_axis", parameter_number(view.limit)}}});
  note_default(finding, view.limit);
  finding.help.push_back({Text::ax3033_help, {{"parameter", parameter_name(view.limit)}}});
  react(finding, "", {Text::ax3033_reaction, {}}, "0");
}

void ipc_no_active_stage(AxisContext const& axis, Report& report) {
  PositionControlView const& view = axis.position_control;
  bool const unknown = std::any_of(view.stages.begin(), view.stages.end(),
                                   [](StageView const& stage) { return stage.mode.unusable; });
  if (!view.enabled() || unknown || !view.active_stages().empty()) return;
  Finding& finding = report.add(view.enable, {Text::ax3035, {}});
  finding.help.push_back({Text::ax3035_help, {{"parameter", parameter_name(view.stages[0].mode)}}});
}

}  // namespace axisc::validator::checks
