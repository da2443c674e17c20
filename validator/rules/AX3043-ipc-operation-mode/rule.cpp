#include "validator/engine/rule.hpp"

#include "validator/views/drive.hpp"
#include "validator/views/position_control_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/position_control_words.hpp"

namespace axisc::validator::checks {
namespace {

void ipc_operation_mode(AxisContext const& axis, Report& report) {
  PositionControlView const& view = axis.position_control;
  EffectiveValue const& mode = axis.values.at("antr.operation_mode");
  if (!view.enabled() || !mode.set() || !is_open_loop(mode)) return;
  Finding& finding = report.add(mode, {Text::ax3043, {{"mode", std::string(mode.value.text)}}});
  finding.notes.push_back({Text::ax3043_limit, {{"p_axis", parameter_number(mode)}}});
  react(finding, {Text::ax3043_reaction, {}});
  relate_enable(finding, view);
}

}  // namespace

extern constinit Rule const ax3043{
    .code = Code{3043},
    .name = "ipc-operation-mode",
    .control = "70602",
    .check = ipc_operation_mode,
};

}  // namespace axisc::validator::checks
