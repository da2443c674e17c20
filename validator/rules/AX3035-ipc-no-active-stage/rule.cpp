#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/views/position_control_view.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax3035::says {

constexpr Sentence headline{
    "Improved Position Control is enabled, but every stage is `NOT_ACTIVE`",
    "die optimierte Lageregelung ist eingeschaltet, aber jede Stufe ist `NOT_ACTIVE`"};
constexpr Sentence help{"`{parameter}` chooses `DIRECT`, `INDIRECT` or `SET_POINT`",
                        "`{parameter}` wählt `DIRECT`, `INDIRECT` oder `SET_POINT`"};

}  // namespace axisc::validator::checks::ax3035::says

namespace axisc::validator::checks::ax3035 {
namespace {

void ipc_no_active_stage(AxisContext const& axis, Report& report) {
  PositionControlView const& view = axis.position_control;
  bool const unknown = std::any_of(view.stages.begin(), view.stages.end(),
                                   [](StageView const& stage) { return stage.mode.unusable; });
  if (!view.enabled() || unknown || !view.active_stages().empty()) return;
  Finding& finding = report.add(view.enable, {says::headline, {}});
  finding.help.push_back({says::help, {{"parameter", parameter_name(view.stages[0].mode)}}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters = "ipc.*",
    .check = ipc_no_active_stage,
};

}  // namespace axisc::validator::checks::ax3035
