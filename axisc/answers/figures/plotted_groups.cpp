#include "axisc/answers/figures/plotted_groups.hpp"

#include <algorithm>
#include <numeric>

namespace axisc {

namespace {

/// The channels as far as an image knows them: those with filters to switch.
machine::Machine channels_of(image::ImageContents const& contents) {
  machine::Machine machine{
      .name = {}, .cycle_time = contents.cycle_time, .axes = {}, .groups = {}, .lists = {}};
  for (auto const& group : contents.groups) {
    machine.groups.push_back({.name = group.name, .axes = group.members, .filter_sets = {}});
  }
  if (machine.groups.empty()) {
    std::vector<std::size_t> axes(std::min(contents.axes.size(), motion::most_axes));
    std::iota(axes.begin(), axes.end(), std::size_t{0});
    machine.groups.push_back({.name = {}, .axes = std::move(axes), .filter_sets = {}});
  }
  return machine;
}

}  // namespace

GroupChains group_chains(InputImage const& input, std::optional<std::string> const& name,
                         ContourRequest const& wanted, std::string const& path) {
  if (!input.machine) {
    auto const machine = channels_of(input.image.contents);
    return {input.image, machine.groups[chosen_group(machine, name, path)], filters_on(), path};
  }
  auto const& machine = input.machine->machine;
  GroupChains chains(machine, chosen_group(machine, name, path), filters_on(), path);
  for (auto const& order : wanted.orders) {
    if (order) chains.add_order(*order);
  }
  return chains;
}

std::vector<std::string> axis_names(image::ImageContents const& contents,
                                    machine::MachineGroup const& group) {
  std::vector<std::string> names;
  for (auto const axis : group.axes) names.push_back(axis_label(contents, axis));
  return names;
}

}  // namespace axisc
