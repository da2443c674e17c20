#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/views/drive.hpp"
#include "validator/views/gantry.hpp"
#include "validator/views/position_control_view.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax4013::says {

constexpr Sentence headline{
    R"(the velocity scaling of the slave "{slave}" differs from that of its master "{master}")",
    "die Geschwindigkeitsnormierung der Slaveachse „{slave}“ weicht von der ihrer Masterachse „{master}“ "
    "ab"};
constexpr Sentence difference{
    R"({p_axis}: `{parameter}` is {slave_value} in "{slave}", {master_value} in "{master}")",
    R"({p_axis}: `{parameter}` ist {slave_value} in „{slave}“, {master_value} in „{master}“)"};
constexpr Sentence also_here{"`{parameter}` is set here", "hier wird `{parameter}` gesetzt"};
constexpr Sentence help{
    "use the same scaling in both lists, unless the drives differ",
    "in beiden Listen dieselbe Skalierung verwenden, außer die Antriebe sind verschieden"};

}  // namespace axisc::validator::checks::ax4013::says

namespace axisc::validator::checks::ax4013 {
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
      report.add(*places.back(), {says::headline, {{"slave", slave.name}, {"master", master.name}}});
  for (Scaling const& pair : differing) {
    finding.notes.push_back({says::difference,
                             {{"parameter", parameter_name(pair.slave)},
                              {"p_axis", parameter_number(pair.slave)},
                              {"slave", slave.name},
                              {"slave_value", number(pair.slave.value.number)},
                              {"master", master.name},
                              {"master_value", number(pair.master.value.number)}}});
  }
  finding.help.push_back({says::help, {}});
  for (EffectiveValue const* const value : places) {
    if (value == places.back()) continue;
    finding.related.push_back(
        {*value->value_place(), {says::also_here, {{"parameter", parameter_name(*value)}}}});
  }
}

void gantry_scaling_differs(MachineContext const& context, Report& report) {
  for (LoadedGantry const& gantry : context.machine.gantries) {
    LoadedAxis const& master = context.machine.axes[gantry.master];
    bool const sends = PositionControlView(master.merged.values).enabled() &&
                       position_controller(master) == machine::PositionController::drive;
    if (!sends) continue;
    for (std::size_t const slave : gantry.slaves) check_slave(context.machine.axes[slave], master, report);
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters =
        "antr.v_reso_num antr.v_reso_denom antr.v_time_base ipc.enable kenngr.achs_mode "
        "kenngr.gantry_ax_nr antr.operation_mode kenngr.antr_typ",
    .check = gantry_scaling_differs,
};

}  // namespace axisc::validator::checks::ax4013
