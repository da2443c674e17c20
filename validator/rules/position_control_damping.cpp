// AX3031 and AX3037: the damping of the simulated vibration, used in INDIRECT and SET_POINT only.
#include "validator/position_control_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/position_control_checks.hpp"

namespace axisc::validator::checks {
namespace {

constexpr double lowest_calm_damping = 0.05;

template <typename Visit>
void for_each_damping(AxisContext const& axis, Visit visit) {
  for (StageView const& stage : axis.position_control.active_stages()) {
    // Without one, the stage has AX3030.
    if (stage.simulates() && configured(stage.damping())) visit(stage, stage.damping());
  }
}

}  // namespace

void ipc_damping_range(AxisContext const& axis, Report& report) {
  for_each_damping(axis, [&](StageView const& stage, EffectiveValue const& damping) {
    double const value = damping.value.number;
    if (value > 0 && value < 1) return;
    Finding& finding = report.add(damping, {Text::ax3031, {{"damping", number(value)}}});
    finding.label = Message{Text::ax3031_label, {}};
    finding.notes.push_back({Text::ax3031_limit, {{"p_axis", parameter_number(damping)}}});
    react(finding, "70599", {Text::ax3031_reaction, {}});
    if (stage.mode.value_place()) {
      finding.related.push_back(
          {*stage.mode.value_place(), {Text::ipc_mode_here, {{"mode", symbol_word(stage.mode)}}}});
    }
  });
}

void ipc_low_damping(AxisContext const& axis, Report& report) {
  for_each_damping(axis, [&](StageView const& /*stage*/, EffectiveValue const& damping) {
    double const value = damping.value.number;
    if (!(value > 0) || value >= lowest_calm_damping) return;
    Finding& finding = report.add(damping, {Text::ax3037, {{"damping", number(value)}}});
    finding.label = Message{Text::ax3037_label, {{"gain", number(1 / (2 * value))}}};
    finding.notes.push_back(
        {Text::ax3037_limit,
         {{"p_axis", parameter_number(damping)}, {"limit", number(lowest_calm_damping)}}});
  });
}

}  // namespace axisc::validator::checks
