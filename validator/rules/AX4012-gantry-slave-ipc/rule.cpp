#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/views/gantry.hpp"
#include "validator/views/position_control_view.hpp"

namespace axisc::validator::checks::ax4012::says {

constexpr Sentence headline{
    "Improved Position Control is enabled in the gantry slave \"{axis}\"",
    "die optimierte Lageregelung ist in der Gantry-Slaveachse „{axis}“ eingeschaltet"};
constexpr Sentence slave_here{"this makes it a slave", "das macht sie zur Slaveachse"};
constexpr Sentence reaction{"it reports an error", "sie meldet einen Fehler"};
constexpr Sentence help{
    "enable it only in the master; the slave gets the master's additive velocity",
    "nur in der Masterachse einschalten; die Slaveachse erhält deren additive Geschwindigkeit"};

}  // namespace axisc::validator::checks::ax4012::says

namespace axisc::validator::checks::ax4012 {
namespace {

void gantry_slave_ipc(AxisContext const& axis, Report& report) {
  PositionControlView const& view = axis.position_control;
  GantryView const gantry(axis.values);
  bool const is_slave = gantry.is_slave() || master_of(axis.machine, axis.index).has_value();
  if (!view.enabled() || !is_slave) return;
  Finding& finding = report.add(view.enable, {says::headline, {{"axis", axis.name}}});
  if (gantry.is_slave() && gantry.mode.value_place()) {
    finding.related.push_back({*gantry.mode.value_place(), {says::slave_here, {}}});
  } else if (GantryClaim const* const claim = slave_claim(axis.machine, axis.index)) {
    finding.related.push_back({claim->place, {says::slave_here, {}}});
  }
  react(finding, {says::reaction, {}});
  finding.help.push_back({says::help, {}});
}

}  // namespace

extern constinit Rule const rule{
    .control = "70600",
    .parameters = "ipc.enable kenngr.achs_mode kenngr.gantry_ax_nr",
    .check = gantry_slave_ipc,
};

}  // namespace axisc::validator::checks::ax4012
