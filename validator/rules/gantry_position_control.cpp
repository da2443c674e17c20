// AX4012 and AX4013: Improved Position Control in a gantry belongs to the master.
#include "validator/drive.hpp"
#include "validator/gantry.hpp"
#include "validator/position_control_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/machine_checks.hpp"

#include <algorithm>
#include <array>

namespace axisc::validator::checks {
namespace {

struct Scaling {
  EffectiveValue const& slave;
  EffectiveValue const& master;
};

std::vector<Scaling> differing_scaling(LoadedAxis const& slave, LoadedAxis const& master) {
  std::vector<Scaling> differing;
  for (std::string_view const name : {"antr.v_reso_num", "antr.v_reso_denom", "antr.v_time_base"}) {
    Scaling const pair{slave.merged.values.at(name), master.merged.values.at(name)};
    bool const usable = !pair.slave.unusable && !pair.master.unusable;
    if (usable && pair.slave.value.number != pair.master.value.number) differing.push_back(pair);
  }
  return differing;
}

/// Every value of `differing` that a list sets, the last one last.
std::vector<EffectiveValue const*> places_of(std::vector<Scaling> const& differing) {
  std::vector<EffectiveValue const*> places;
  for (Scaling const& pair : differing) {
    for (EffectiveValue const* const value : {&pair.slave, &pair.master}) {
      if (value->value_place()) places.push_back(value);
    }
  }
  std::sort(places.begin(), places.end(), [](EffectiveValue const* left, EffectiveValue const* right) {
    return *left->value_place() < *right->value_place();
  });
  return places;
}

void check_slave(LoadedAxis const& slave, LoadedAxis const& master, Report& report) {
  std::vector<Scaling> const differing = differing_scaling(slave, master);
  std::vector<EffectiveValue const*> const places = places_of(differing);
  if (places.empty()) return;
  report.axis = slave.name;
  Finding& finding =
      report.add(*places.back(), {Text::ax4013, {{"slave", slave.name}, {"master", master.name}}});
  for (Scaling const& pair : differing) {
    finding.notes.push_back({Text::ax4013_difference,
                             {{"parameter", parameter_name(pair.slave)},
                              {"p_axis", parameter_number(pair.slave)},
                              {"slave", slave.name},
                              {"slave_value", number(pair.slave.value.number)},
                              {"master", master.name},
                              {"master_value", number(pair.master.value.number)}}});
  }
  for (EffectiveValue const* const value : places) {
    if (value == places.back()) continue;
    finding.related.push_back(
        {*value->value_place(), {Text::ax4013_also_here, {{"parameter", parameter_name(*value)}}}});
  }
}

}  // namespace

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
  react(finding, "70600", {Text::ax4012_reaction, {}});
  finding.help.push_back({Text::ax4012_help, {}});
}

void gantry_scaling_differs(MachineContext const& context, Report& report) {
  for (LoadedGantry const& gantry : context.machine.gantries) {
    LoadedAxis const& master = context.machine.axes[gantry.master];
    bool const sends = PositionControlView(master.merged.values).enabled() &&
                       position_controller(master) == PositionController::drive;
    if (!sends) continue;
    for (std::size_t const slave : gantry.slaves) check_slave(context.machine.axes[slave], master, report);
  }
}

}  // namespace axisc::validator::checks
