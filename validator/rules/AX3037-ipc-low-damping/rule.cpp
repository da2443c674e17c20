#include "validator/engine/rule.hpp"

#include "validator/views/position_control_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/position_control_words.hpp"

namespace axisc::validator::checks {
namespace {

constexpr double lowest_calm_damping = 0.05;

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

}  // namespace

extern constinit Rule const ax3037{
    .code = Code{3037},
    .name = "ipc-low-damping",
    .severity = Severity::warning,
    .check = ipc_low_damping,
};

}  // namespace axisc::validator::checks
