#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/position_control_words.hpp"
#include "validator/views/position_control_view.hpp"

namespace axisc::validator::checks::ax3037::says {

constexpr Sentence headline{"a damping of {damping} causes large additive velocities",
                            "eine Dämpfung von {damping} ergibt große additive Geschwindigkeiten"};
constexpr Sentence label{"the simulation amplifies its frequency by a factor of {gain}",
                         "die Simulation verstärkt ihre Frequenz auf das {gain}fache"};
constexpr Sentence limit{
    "{p_axis}: below {limit} the drive may start to oscillate; lower the damping in small steps",
    "{p_axis}: unter {limit} kann der Antrieb aufschwingen; die Dämpfung in kleinen Schritten senken"};

}  // namespace axisc::validator::checks::ax3037::says

namespace axisc::validator::checks::ax3037 {
namespace {

constexpr double lowest_calm_damping = 0.05;

void ipc_low_damping(AxisContext const& axis, Report& report) {
  for_each_damping(axis, [&](StageView const& /*stage*/, EffectiveValue const& damping) {
    double const value = damping.value.number;
    if (!(value > 0) || value >= lowest_calm_damping) return;
    Finding& finding = report.add(damping, {says::headline, {{"damping", number(value)}}});
    finding.label = Message{says::label, {{"gain", number(1 / (2 * value))}}};
    finding.notes.push_back(
        {says::limit, {{"p_axis", parameter_number(damping)}, {"limit", number(lowest_calm_damping)}}});
  });
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters = "ipc.stage[].filter.damping ipc.stage[].osc_damping ipc.stage[].mode ipc.enable",
    .check = ipc_low_damping,
};

}  // namespace axisc::validator::checks::ax3037
