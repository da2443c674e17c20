#include "configuration/machine/guards.hpp"

#include <algorithm>
#include <optional>

namespace axisc::machine {
namespace {

bool contains(MachineGroup const& group, std::size_t axis) {
  return std::find(group.axes.begin(), group.axes.end(), axis) != group.axes.end();
}

void give(AxisConfiguration& axis, std::optional<design::KernelSpecification> const& guard) {
  if (axis.type == AxisType::spindle || axis.kernel || !guard) return;
  axis.kernel = ConfiguredKernel{
      .family = KernelFamily::guard, .index = 0, .specification = *guard, .on_at_start = false};
}

}  // namespace

void add_guards(Machine& machine, std::size_t group) {
  MachineGroup const& channel = machine.groups[group];
  for (std::size_t const axis : channel.axes) give(machine.axes[axis], machine.axes[axis].listed_guard);
  for (std::size_t const slave : followers(machine, channel)) {
    give(machine.axes[slave], machine.axes[*machine.axes[slave].gantry_master].listed_guard);
  }
}

std::vector<std::size_t> followers(Machine const& machine, MachineGroup const& group) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < machine.axes.size(); ++i) {
    auto const& master = machine.axes[i].gantry_master;
    bool const is_grouped = std::any_of(machine.groups.begin(), machine.groups.end(),
                                        [&](MachineGroup const& one) { return contains(one, i); });
    if (master && contains(group, *master) && !is_grouped) found.push_back(i);
  }
  return found;
}

}  // namespace axisc::machine
