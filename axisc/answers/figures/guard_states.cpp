#include "axisc/answers/figures/guard_states.hpp"

#include <algorithm>
#include <map>

namespace axisc {

namespace {

/// Guards of one axis by command; the empty one is that of the lists.
using GuardsByCommand = std::map<std::string, ShownGuard>;

ShownGuard shown_guard(image::ImageKernel const& kernel, design::CycleTime cycle_time) {
  auto const& guard = kernel.specification;
  return {.specification = guard,
          .design = kernel.design,
          .cycle_time = cycle_time,
          .interval = design::robustness(kernel.design, guard, cycle_time),
          .residual = design::residual_at_design(kernel.design, guard, cycle_time)};
}

GuardsByCommand guards_of(image::ImageContents const& contents, std::size_t axis) {
  GuardsByCommand found;
  auto const add = [&](std::string command, std::optional<std::size_t> kernel) {
    if (!kernel) return;
    auto guard = shown_guard(contents.kernels[*kernel], contents.cycle_time);
    auto const listed = found.find("");
    if (listed == found.end() || !(listed->second == guard)) {
      found.emplace(std::move(command), std::move(guard));
    }
  };
  auto const& slot = contents.axes[axis].slot;
  if (!slot || slot->family != machine::KernelFamily::guard) return found;
  add("", slot->kernel);
  for (auto const& group : contents.groups) {
    auto const member = std::find(group.members.begin(), group.members.end(), axis);
    if (member == group.members.end()) continue;
    for (auto const& bank : group.banks) {
      if (bank.family() != machine::KernelFamily::guard) continue;
      add(to_text(machine::FilterCommand{.filter_switch = machine::FilterSwitch::on,
                                         .parameters = bank.parameters}),
          bank.kernels[static_cast<std::size_t>(member - group.members.begin())]);
    }
  }
  return found;
}

std::optional<ShownGuard> guard_in(GuardsByCommand const& guards, std::string const& command) {
  auto const found = guards.find(command);
  return found == guards.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

std::vector<GuardStates> guard_states(PlotSubject const& subject) {
  std::vector<GuardStates> states;
  auto const add = [&](GuardStates state) {
    auto const same = std::find_if(states.begin(), states.end(), [&](GuardStates const& known) {
      return known.command == state.command && known.now == state.now && known.before == state.before;
    });
    if (same == states.end()) {
      states.push_back(std::move(state));
    } else {
      same->axes += ", " + state.axes;
    }
  };
  for (auto const axis : subject.axes) {
    auto const now = guards_of(subject.contents(), axis);
    auto const old = subject.axis_before(axis);
    auto const before = old ? guards_of(subject.before->contents(), *old) : GuardsByCommand();
    for (auto const& [command, guard] : now) {
      add({.axes = subject.name(axis),
           .command = command,
           .now = guard,
           .before = guard_in(before, command)});
    }
    for (auto const& [command, guard] : before) {
      if (now.contains(command)) continue;
      add({.axes = subject.name(axis), .command = command, .now = std::nullopt, .before = guard});
    }
  }
  std::stable_sort(states.begin(), states.end(), [](GuardStates const& one, GuardStates const& other) {
    return one.command.empty() && !other.command.empty();
  });
  return states;
}

}  // namespace axisc
