#include "configuration/machine/part.hpp"

#include <algorithm>
#include <map>

namespace axisc::machine {
namespace {

AxisConfiguration without_values(AxisConfiguration const& axis) {
  return {.name = axis.name,
          .number = axis.number,
          .type = axis.type,
          .filters = axis.filters,
          .interface_filters = axis.interface_filters,
          .kernel = axis.kernel,
          .listed_guard = axis.listed_guard,
          .position_control = axis.position_control,
          .drive_scaling = axis.drive_scaling,
          .gantry_master = axis.gantry_master,
          .drive_path = axis.drive_path,
          .fed_forward_path = axis.fed_forward_path,
          .position_window = axis.position_window,
          .velocity_limit = axis.velocity_limit,
          .acceleration_limit = axis.acceleration_limit,
          .transition_weight = axis.transition_weight,
          .dynamics = axis.dynamics,
          .values = {}};
}

}  // namespace

MachinePart part_of(Machine const& whole, std::span<std::size_t const> axes) {
  MachinePart part{.machine = {.name = whole.name,
                               .cycle_time = whole.cycle_time,
                               .axes = {},
                               .groups = {},
                               .lists = {},
                               .inch = whole.inch,
                               .motion = whole.motion},
                   .groups = {}};
  std::vector<std::size_t> kept(axes.begin(), axes.end());
  std::map<std::size_t, std::size_t> places;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    places.emplace(kept[i], i);
    auto const master = whole.axes[kept[i]].gantry_master;
    if (master && std::find(kept.begin(), kept.end(), *master) == kept.end()) kept.push_back(*master);
  }
  for (std::size_t const axis : kept) {
    AxisConfiguration& own = part.machine.axes.emplace_back(without_values(whole.axes[axis]));
    if (own.gantry_master) own.gantry_master = places.at(*own.gantry_master);
  }
  for (std::size_t i = 0; i < whole.groups.size(); ++i) {
    MachineGroup const& group = whole.groups[i];
    std::vector<std::size_t> members;
    for (std::size_t const axis : group.axes) {
      auto const place = places.find(axis);
      if (place != places.end() && place->second < axes.size()) members.push_back(place->second);
    }
    if (members.empty()) continue;
    part.machine.groups.push_back({.name = group.name,
                                   .axes = std::move(members),
                                   .filter_sets = group.filter_sets,
                                   .programs = group.programs,
                                   .dynamics = group.dynamics});
    part.groups.push_back(i);
  }
  return part;
}

}  // namespace axisc::machine
