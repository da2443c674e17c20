#include "configuration/machine/guards.hpp"

#include <algorithm>

namespace axisc::machine {

void add_guards(Machine& machine, std::size_t group) {
  for (std::size_t const index : machine.groups[group].axes) {
    AxisConfiguration& axis = machine.axes[index];
    if (axis.type == AxisType::spindle || axis.kernel || !axis.listed_guard) continue;
    axis.kernel = ConfiguredKernel{
        .family = KernelFamily::guard, .index = 0, .specification = *axis.listed_guard, .on_at_start = false};
  }
}

bool has_guard(Machine const& machine, MachineGroup const& group) {
  return std::any_of(group.axes.begin(), group.axes.end(), [&](std::size_t axis) {
    auto const& kernel = machine.axes[axis].kernel;
    return kernel && kernel->family == KernelFamily::guard;
  });
}

}  // namespace axisc::machine
