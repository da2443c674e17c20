#include "codegen/kernel_plan.hpp"

#include "codegen/fade.hpp"
#include "configuration/machine/guards.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace axisc::codegen {
namespace {

class Planner {
 public:
  Planner(machine::Machine const& machine, CompiledKernels& kernels,
          std::function<double(std::size_t)> const& peak_gain)
      : machine_(machine), kernels_(kernels), peak_gain_(peak_gain), slot_of_axis_(machine.axes.size()) {}

  KernelPlan plan() {
    add_slots();
    for (machine::MachineGroup const& group : machine_.groups) add_group(group);
    for (PlannedSlot& slot : plan_.slots) slot.history = longest(slot);
    for (PlannedGroup& group : plan_.groups) set_fades(group);
    return std::move(plan_);
  }

 private:
  void add_slots() {
    for (std::size_t axis = 0; axis < machine_.axes.size(); ++axis) {
      auto const& configured = machine_.axes[axis].kernel;
      if (!configured) continue;
      slot_of_axis_[axis] = plan_.slots.size();
      plan_.slots.push_back({.axis = axis,
                             .family = configured->family,
                             .index = configured->index,
                             .kernel = kernels_.index_of(configured->specification),
                             .on_at_start = configured->on_at_start,
                             .history = 0,
                             .group = std::nullopt,
                             .member = 0});
      reachable_.push_back({no_kernel, plan_.slots.back().kernel});
    }
  }

  void add_group(machine::MachineGroup const& group) {
    std::size_t const index = plan_.groups.size();
    PlannedGroup planned{.name = group.name, .members = {}, .banks = {}, .off_fade_cycles = 0};
    bool has_slot = false;
    bool has_hsc = false;
    bool has_guard = false;
    for (std::size_t const axis : reached_by(group)) {
      if (auto const slot_index = slot_of_axis_[axis]) {
        PlannedSlot& slot = plan_.slots[*slot_index];
        if (slot.group) continue;
        slot.group = index;
        slot.member = planned.members.size();
        has_slot = true;
        has_hsc = has_hsc || slot.family == machine::KernelFamily::hsc;
        has_guard = has_guard || slot.family == machine::KernelFamily::guard;
      }
      planned.members.push_back(axis);
    }
    if (!has_slot) return;
    plan_.groups.push_back(std::move(planned));
    add_bank(index, {}, false);
    for (auto const& parameters : group.filter_sets) {
      if (!parameters.empty()) add_bank(index, parameters, false);
    }
    if (has_hsc) add_bank(index, {}, true);
    if (has_guard) add_bank(index, machine::guard_parameters(), false);
  }

  /// The channel's axes, and slaves of gantries with a guard, which follow their master's commands.
  [[nodiscard]] std::vector<std::size_t> reached_by(machine::MachineGroup const& group) const {
    std::vector<std::size_t> axes = group.axes;
    for (std::size_t const slave : machine::followers(machine_, group)) {
      auto const& kernel = machine_.axes[slave].kernel;
      if (kernel && kernel->family == machine::KernelFamily::guard) axes.push_back(slave);
    }
    return axes;
  }

  void add_bank(std::size_t group, machine::FilterParameters const& parameters, bool hsc) {
    PlannedGroup& planned = plan_.groups[group];
    PlannedBank bank{.parameters = parameters, .hsc = hsc, .choices = {}, .fade_cycles = 0};
    for (std::size_t member = 0; member < planned.members.size(); ++member) {
      bank.choices.push_back(choice(group, member, bank));
    }
    planned.banks.push_back(std::move(bank));
  }

  /// The kernel of a member; none for an axis that the bank does not concern.
  std::uint32_t choice(std::size_t group, std::size_t member, PlannedBank const& bank) {
    auto const slot_index = slot_of_axis_[plan_.groups[group].members[member]];
    if (!slot_index) return no_kernel;
    PlannedSlot const& slot = plan_.slots[*slot_index];
    if (slot.family != machine::family_of(bank.parameters, bank.hsc)) return no_kernel;
    auto const& listed = machine_.axes[slot.axis].kernel->specification;
    std::uint32_t const kernel = kernels_.index_of(with_parameters(listed, bank.parameters));
    reachable_[*slot_index].insert(kernel);
    return kernel;
  }

  [[nodiscard]] std::uint32_t longest(PlannedSlot const& slot) const {
    std::size_t tails = 0;
    for (std::uint32_t const kernel : reachable_[*slot_of_axis_[slot.axis]]) {
      if (kernel != no_kernel) tails = std::max(tails, kernels_[kernel].design.tail_sums.size());
    }
    return static_cast<std::uint32_t>(tails);
  }

  /// Cycles from the worst kernel that `slot` may be at to `kernel`; 0 where standstill is needed.
  [[nodiscard]] std::uint32_t slot_fade(PlannedSlot const& slot, std::uint32_t kernel) const {
    machine::AxisConfiguration const& axis = machine_.axes[slot.axis];
    double distance = 0;
    for (std::uint32_t const from : reachable_[*slot_of_axis_[slot.axis]]) {
      distance = std::max(distance, tail_distance(design_of(from), design_of(kernel)));
    }
    MotionLimits const limits =
        motion_limits(axis.velocity_limit, axis.acceleration_limit, machine_.cycle_time);
    return fade_cycles(distance * peak_gain_(slot.axis), limits);
  }

  [[nodiscard]] design::KernelDesign const* design_of(std::uint32_t kernel) const {
    return kernel == no_kernel ? nullptr : &kernels_[kernel].design;
  }

  /// All axes of a channel change over together: the longest fade of any of them.
  void set_fades(PlannedGroup& group) const {
    for (PlannedBank& bank : group.banks) {
      bank.fade_cycles = group_fade(group, [&](PlannedSlot const& slot, std::size_t member) {
        return slot.family == machine::family_of(bank.parameters, bank.hsc)
                   ? std::optional(bank.choices[member])
                   : std::nullopt;
      });
    }
    // At the program's end guards return to the lists' values, which a runtime takes for a switch to OFF.
    std::uint32_t const off =
        group_fade(group, [](PlannedSlot const&, std::size_t) { return std::optional(no_kernel); });
    group.off_fade_cycles = off;
    for (PlannedBank const& bank : group.banks) {
      if (!bank.parameters.guard || !bank.parameters.empty()) continue;
      bool const only_at_rest = off == 0 || bank.fade_cycles == 0;
      group.off_fade_cycles = only_at_rest ? 0 : std::max(off, bank.fade_cycles);
    }
  }

  template <class TargetOf>
  [[nodiscard]] std::uint32_t group_fade(PlannedGroup const& group, TargetOf target_of) const {
    std::uint32_t longest = 1;
    for (std::size_t member = 0; member < group.members.size(); ++member) {
      auto const slot_index = slot_of_axis_[group.members[member]];
      if (!slot_index) continue;
      PlannedSlot const& slot = plan_.slots[*slot_index];
      std::optional<std::uint32_t> const target = target_of(slot, member);
      if (!target) continue;
      std::uint32_t const cycles = slot_fade(slot, *target);
      if (cycles == 0) return 0;
      longest = std::max(longest, cycles);
    }
    return longest;
  }

  machine::Machine const& machine_;
  CompiledKernels& kernels_;
  std::function<double(std::size_t)> const& peak_gain_;
  std::vector<std::optional<std::size_t>> slot_of_axis_;
  std::vector<std::set<std::uint32_t>> reachable_;  ///< kernels of each slot
  KernelPlan plan_;
};

}  // namespace

KernelPlan plan_kernels(machine::Machine const& machine, CompiledKernels& kernels,
                        std::function<double(std::size_t axis)> const& peak_gain) {
  return Planner(machine, kernels, peak_gain).plan();
}

}  // namespace axisc::codegen
