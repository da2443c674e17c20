#include "validator/engine/rule.hpp"

#include "validator/views/gantry.hpp"
#include "validator/views/position_control_view.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

void gantry_slave_ipc(AxisContext const& axis, Report& report) {
  PositionControlView const& view = axis.position_control;
  GantryView const gantry(axis.values);
  bool const is_slave = gantry.is_slave() || master_of(axis.machine, axis.index).has_value();
  if (!view.enabled() || !is_slave) return;
  Finding& finding = report.add(view.enable, {Text::ax4012, {{"axis", axis.name}}});
  if (gantry.is_slave() && gantry.mode.value_place()) {
    finding.related.push_back({*gantry.mode.value_place(), {Text::ax4012_slave_here, {}}});
  } else if (GantryClaim const* const claim = slave_claim(axis.machine, axis.index)) {
    finding.related.push_back({claim->place, {Text::ax4012_slave_here, {}}});
  }
  react(finding, {Text::ax4012_reaction, {}});
  finding.help.push_back({Text::ax4012_help, {}});
}

}  // namespace

extern constinit Rule const ax4012{
    .code = Code{4012},
    .name = "gantry-slave-ipc",
    .control = "70600",
    .check = gantry_slave_ipc,
};

}  // namespace axisc::validator::checks
