#include "validator/engine/rule.hpp"

#include "validator/views/position_control_view.hpp"
#include "validator/rules/filter_words.hpp"

#include <algorithm>

namespace axisc::validator::checks {
namespace {

void ipc_no_active_stage(AxisContext const& axis, Report& report) {
  PositionControlView const& view = axis.position_control;
  bool const unknown = std::any_of(view.stages.begin(), view.stages.end(),
                                   [](StageView const& stage) { return stage.mode.unusable; });
  if (!view.enabled() || unknown || !view.active_stages().empty()) return;
  Finding& finding = report.add(view.enable, {Text::ax3035, {}});
  finding.help.push_back({Text::ax3035_help, {{"parameter", parameter_name(view.stages[0].mode)}}});
}

}  // namespace

extern constinit Rule const ax3035{
    .code = Code{3035},
    .name = "ipc-no-active-stage",
    .severity = Severity::warning,
    .check = ipc_no_active_stage,
};

}  // namespace axisc::validator::checks
