#include "validator/engine/rule.hpp"

#include "validator/views/position_control_view.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

void ipc_without_limit(AxisContext const& axis, Report& report) {
  PositionControlView const& view = axis.position_control;
  if (!view.enabled() || view.limit.unusable || view.limit.value.number != 0) return;
  Finding& finding = report.add(view.limit.set() ? view.limit : view.enable, {Text::ax3033, {}});
  finding.notes.push_back({Text::ax3033_limit, {{"p_axis", parameter_number(view.limit)}}});
  note_default(finding, view.limit);
  finding.help.push_back({Text::ax3033_help, {{"parameter", parameter_name(view.limit)}}});
  react(finding, {Text::ax3033_reaction, {}}, "0");
}

}  // namespace

extern constinit Rule const ax3033{
    .code = Code{3033},
    .name = "ipc-without-limit",
    .severity = Severity::warning,
    .check = ipc_without_limit,
};

}  // namespace axisc::validator::checks
