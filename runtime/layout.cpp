#include "runtime/layout.hpp"

#include "runtime/runtime_object.hpp"

namespace axisc::runtime {
namespace {

/// Hands out memory from the beginning to the end.
class Reservation {
 public:
  template <class T>
  uint64_t take(uint64_t count) {
    static_assert(alignof(T) <= AXISRT_ALIGNMENT);
    uint64_t const offset = end_;
    uint64_t const bytes = count * sizeof(T);  // NOLINT(bugprone-sizeof-expression): some parts hold pointers
    end_ += (bytes + AXISRT_ALIGNMENT - 1) / AXISRT_ALIGNMENT * AXISRT_ALIGNMENT;
    return offset;
  }
  [[nodiscard]] uint64_t end() const { return end_; }

 private:
  uint64_t end_ = 0;
};

}  // namespace

uint64_t history_length(Record<record::slot> slot) {
  uint32_t const history = slot[field::slot::history];
  return history > 0 ? history : 1;
}

Amounts count_amounts(ImageView const& view) {
  Amounts amounts{
      .axes = view.axes.count, .filters = view.filters.count, .sections = view.coefficients.count};
  for (uint32_t i = 0; i < view.filters.count; ++i) {
    amounts.section_states += view.filters[i][field::filter::section_count];
    amounts.ring_signals += view.filters[i][field::filter::delay_cycles];
  }
  amounts.kernels = uint64_t{view.kernels.count} + 1;
  amounts.tails = view.tails.count;
  amounts.slots = view.slots.count;
  for (uint32_t i = 0; i < view.slots.count; ++i) amounts.history += 2 * history_length(view.slots[i]);
  amounts.groups = view.groups.count;
  amounts.members = view.members.count;
  amounts.banks = view.banks.count;
  amounts.choices = view.choices.count;
  amounts.controls = view.controls.count;
  amounts.stages = view.stages.count;
  return amounts;
}

Layout lay_out(Amounts const& amounts) {
  Reservation memory;
  Layout layout;
  layout.object = memory.take<axisrt>(1);
  layout.axes = memory.take<Axis>(amounts.axes);
  layout.setpoint_chains = memory.take<Chain>(amounts.axes);
  layout.interface_chains = memory.take<Chain>(amounts.axes);
  layout.filters = memory.take<Filter>(amounts.filters);
  layout.sections = memory.take<Section>(amounts.sections);
  layout.kernels = memory.take<Kernel>(amounts.kernels);
  layout.tails = memory.take<double>(amounts.tails);
  layout.slots = memory.take<Slot>(amounts.slots);
  layout.groups = memory.take<Group>(amounts.groups);
  layout.members = memory.take<Slot const*>(amounts.members);
  layout.banks = memory.take<Bank>(amounts.banks);
  layout.choices = memory.take<Kernel const*>(amounts.choices);
  layout.controls = memory.take<Control>(amounts.controls);
  layout.stages = memory.take<Stage>(amounts.stages);
  layout.setpoint_states = memory.take<ChainState>(amounts.axes);
  layout.interface_states = memory.take<ChainState>(amounts.axes);
  layout.section_states = memory.take<SectionState>(amounts.section_states);
  layout.ring_positions = memory.take<uint32_t>(amounts.filters);
  layout.ring_signals = memory.take<Signal>(amounts.ring_signals);
  layout.slot_states = memory.take<SlotState>(amounts.slots);
  layout.history = memory.take<double>(amounts.history);
  layout.stage_states = memory.take<ChainState>(amounts.stages);
  layout.additive_velocities = memory.take<double>(amounts.controls);
  layout.size = memory.end();
  return layout;
}

}  // namespace axisc::runtime
