#include "validator/rules/guards.hpp"

#include <algorithm>

namespace axisc::validator::checks {
namespace {

bool is_guard(grammar::NcCommand const& command) {
  return command.kind == grammar::CommandKind::vibration_guard;
}

}  // namespace

std::vector<CommandedGuard> commanded_guards(ProgramContext const& context) {
  std::vector<CommandedGuard> found;
  if (context.group == nullptr) return found;
  LoadedMachine const& machine = context.whole.machine;
  CommandLimits const limits{.cycle_time = context.whole.cycle_time, .readings = machine.readings};
  machine::FilterParameters in_force = machine::guard_parameters();
  for (grammar::NcCommand const& command : context.program.tree.commands) {
    if (!is_guard(command)) continue;
    auto const checked = check_command(command, context.text, limits, Variables::accepted);
    if (!checked.command || checked.filter_switch == machine::FilterSwitch::off) continue;
    in_force = machine::parameters_after(in_force, *checked.command);
    std::size_t const first = found.size();
    for (std::size_t const index : context.group->axes) {
      LoadedAxis const& axis = machine.axes[index];
      if (axis.type == machine::AxisType::spindle) continue;
      auto const listed = GuardView(axis.merged.values).specification(context.whole.cycle_time);
      auto const guard = listed ? guard_after(*listed, in_force) : std::nullopt;
      if (!guard) continue;
      bool const is_known = std::any_of(found.begin() + static_cast<std::ptrdiff_t>(first), found.end(),
                                        [&](CommandedGuard const& one) { return one.guard == *guard; });
      if (is_known) continue;
      found.push_back({.place = {.source = context.program.source, .span = command.name},
                       .axis = axis.name,
                       .guard = *guard});
    }
  }
  return found;
}

bool commands_guard(LoadedMachine const& machine) {
  for (LoadedProgram const& program : machine.programs) {
    auto const& commands = program.tree.commands;
    if (std::any_of(commands.begin(), commands.end(), is_guard)) return true;
  }
  return std::any_of(machine.filter_sets.begin(), machine.filter_sets.end(),
                     [](configuration::LocatedText const& set) {
                       auto const command = grammar::parse_nc_command(set.text);
                       return command && is_guard(*command);
                     });
}

}  // namespace axisc::validator::checks
