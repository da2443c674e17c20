#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/helpers.hpp"

namespace axisc::validator::checks::ax4023::says {

constexpr Sentence headline{
    R"(gantry "{master}"/"{slave}": `{parameter}` is {slave_value} in the slave, {master_value} in the master)",
    "Gantry „{master}“/„{slave}“: `{parameter}` ist {slave_value} in der Slaveachse, {master_value} in der "
    "Masterachse"};
constexpr Sentence one_motion{
    "the slave makes the motion that is planned with the master's limits",
    "die Slaveachse führt die Bewegung aus, die mit den Grenzen der Masterachse geplant wird"};
constexpr Sentence master_here{"the value of the master", "der Wert der Masterachse"};
constexpr Sentence help{"give master and slave the same limits",
                        "Master- und Slaveachse dieselben Grenzen geben"};

}  // namespace axisc::validator::checks::ax4023::says

namespace axisc::validator::checks::ax4023 {
namespace {

void check_limit(LoadedAxis const& master, LoadedAxis const& slave, std::string_view name, Report& report) {
  EffectiveValue const& own = slave.merged.values.at(name);
  EffectiveValue const& leading = master.merged.values.at(name);
  if (own.unusable || leading.unusable || own.value.number == leading.value.number) return;
  EffectiveValue const& at = own.value_place() ? own : leading;
  if (!at.value_place()) return;
  report.axis = slave.name;
  Finding& finding = report.add(at, {says::headline,
                                     {{"master", master.name},
                                      {"slave", slave.name},
                                      {"parameter", parameter_name(own)},
                                      {"slave_value", number(own.value.number)},
                                      {"master_value", number(leading.value.number)}}});
  finding.notes.push_back({says::one_motion, {}});
  if (&at == &own && leading.value_place()) {
    finding.related.push_back({*leading.value_place(), {says::master_here, {}}});
  }
  finding.help.push_back({says::help, {}});
}

void gantry_limits_differ(MachineContext const& context, Report& report) {
  for (LoadedGantry const& gantry : context.machine.gantries) {
    LoadedAxis const& master = context.machine.axes[gantry.master];
    for (std::size_t const slave : gantry.slaves) {
      for (std::string_view const name : {"getriebe[].dynamik.vb_max", "getriebe[].dynamik.a_max"}) {
        check_limit(master, context.machine.axes[slave], name, report);
      }
    }
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters = "getriebe[].dynamik.a_max getriebe[].dynamik.vb_max kenngr.achs_mode kenngr.gantry_ax_nr",
    .check = gantry_limits_differ,
};

}  // namespace axisc::validator::checks::ax4023
