#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/position_control_words.hpp"
#include "validator/views/position_control_view.hpp"

namespace axisc::validator::checks::ax3031::says {

constexpr Sentence headline{"with a damping of {damping} there is no vibration to simulate",
                            "mit einer Dämpfung von {damping} gibt es keine Schwingung zu simulieren"};
constexpr Sentence label{"must lie between 0 and 1", "muss zwischen 0 und 1 liegen"};
constexpr Sentence limit{"{p_axis}: 0 < damping < 1 in INDIRECT and SET_POINT",
                         "{p_axis}: 0 < damping < 1 in INDIRECT und SET_POINT"};
constexpr Sentence reaction{"it reports the damping as out of range",
                            "sie meldet die Dämpfung als außerhalb des Bereichs"};
constexpr Sentence help{
    "compute it from the measured decay, or start near 1 and lower it step by step",
    "sie aus dem gemessenen Abklingen berechnen, oder nahe 1 beginnen und schrittweise senken"};

}  // namespace axisc::validator::checks::ax3031::says

namespace axisc::validator::checks::ax3031 {
namespace {

void ipc_damping_range(AxisContext const& axis, Report& report) {
  for_each_damping(axis, [&](StageView const& stage, EffectiveValue const& damping) {
    double const value = damping.value.number;
    if (value > 0 && value < 1) return;
    Finding& finding = report.add(damping, {says::headline, {{"damping", number(value)}}});
    finding.label = Message{says::label, {}};
    finding.notes.push_back({says::limit, {{"p_axis", parameter_number(damping)}}});
    finding.help.push_back({says::help, {}});
    react(finding, {says::reaction, {}});
    relate_mode(finding, stage);
  });
}

}  // namespace

extern constinit Rule const rule{
    .control = "70599",
    .parameters = "ipc.stage[].filter.damping ipc.stage[].osc_damping ipc.stage[].mode ipc.enable",
    .check = ipc_damping_range,
};

}  // namespace axisc::validator::checks::ax3031
