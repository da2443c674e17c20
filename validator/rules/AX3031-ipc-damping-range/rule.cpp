#include "validator/engine/rule.hpp"

#include "validator/views/position_control_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/position_control_words.hpp"

namespace axisc::validator::checks {
namespace {

void ipc_damping_range(AxisContext const& axis, Report& report) {
  for_each_damping(axis, [&](StageView const& stage, EffectiveValue const& damping) {
    double const value = damping.value.number;
    if (value > 0 && value < 1) return;
    Finding& finding = report.add(damping, {Text::ax3031, {{"damping", number(value)}}});
    finding.label = Message{Text::ax3031_label, {}};
    finding.notes.push_back({Text::ax3031_limit, {{"p_axis", parameter_number(damping)}}});
    react(finding, {Text::ax3031_reaction, {}});
    relate_mode(finding, stage);
  });
}

}  // namespace

extern constinit Rule const ax3031{
    .code = Code{3031},
    .name = "ipc-damping-range",
    .control = "70599",
    .check = ipc_damping_range,
};

}  // namespace axisc::validator::checks
