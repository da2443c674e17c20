#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/views/position_control_view.hpp"

namespace axisc::validator::checks::ax3033::says {

constexpr Sentence headline{
    "the additive velocity is limited to 0: Improved Position Control has no effect",
    "die additive Geschwindigkeit ist auf 0 begrenzt: die optimierte Lageregelung hat keine Wirkung"};
constexpr Sentence limit{"{p_axis}: |v_add| ≤ v_add_max_fact / 1000 · vb_max (P-AXIS-00212)",
                         "{p_axis}: |v_add| ≤ v_add_max_fact / 1000 · vb_max (P-AXIS-00212)"};
constexpr Sentence help{"`{parameter} 100` allows a tenth of the maximum velocity of the axis",
                        "`{parameter} 100` erlaubt ein Zehntel der Höchstgeschwindigkeit der Achse"};
constexpr Sentence reaction{"it limits without a message", "sie begrenzt ohne Meldung"};

}  // namespace axisc::validator::checks::ax3033::says

namespace axisc::validator::checks::ax3033 {
namespace {

void ipc_without_limit(AxisContext const& axis, Report& report) {
  PositionControlView const& view = axis.position_control;
  if (!view.enabled() || view.limit.unusable || view.limit.value.number != 0) return;
  Finding& finding = report.add(view.limit.set() ? view.limit : view.enable, {says::headline, {}});
  finding.notes.push_back({says::limit, {{"p_axis", parameter_number(view.limit)}}});
  note_default(finding, view.limit);
  finding.help.push_back({says::help, {{"parameter", parameter_name(view.limit)}}});
  react(finding, {says::reaction, {}}, "0");
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters = "ipc.v_add_max_fact ipc.enable",
    .check = ipc_without_limit,
};

}  // namespace axisc::validator::checks::ax3033
