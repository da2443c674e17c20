#include "runtime/creation/layout.hpp"

#include "runtime/creation/building.hpp"
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

PortAmounts count_port(ImageView const& view, PortKind port, uint32_t lanes) {
  PortAmounts amounts{.lines = count_lines(view, port)};
  Grouping grouping(view, port, lanes);
  Group group{};
  Group before{};
  bool first = true;
  while (grouping.next(group)) {
    bool const continues = !first && same_layout(before, group);
    amounts.batches += continues ? 0 : 1;
    amounts.operations += continues ? 0 : group.shape.step_count;
    amounts.lanes += group.width;
    amounts.states += state_stride(group);
    for (uint32_t i = 0; i < group.shape.step_count; ++i) {
      Shape::Step const& step = group.shape.steps[i];
      amounts.pieces += 1;
      if (!continues || !same_constants(view, port, before, group, i)) {
        amounts.constants += whole_lines(uint64_t{constants_size(step)} * group.width);
      }
      if (step.kind != OperationKind::slot) continue;
      amounts.slot_groups += 1;
      amounts.lane_tails += 2 * uint64_t{padded_tails(step.block_count)} * group.width;
    }
    before = group;
    first = false;
  }
  return amounts;
}

PortLayout lay_out_port(PortAmounts const& amounts, Reservation& memory) {
  PortLayout layout;
  layout.batches = memory.take<Batch>(amounts.batches);
  layout.lines = memory.take<LineChain>(amounts.lines);
  layout.lanes = memory.take<uint32_t>(amounts.lanes);
  layout.pieces = memory.take<double const*>(amounts.pieces);
  layout.constants = memory.take<double>(amounts.constants);
  layout.batch_states = memory.take<BatchState>(amounts.batches);
  layout.operation_states = memory.take<OperationState>(amounts.operations);
  layout.slot_groups = memory.take<SlotGroup>(amounts.slot_groups);
  layout.lane_tails = memory.take<double>(amounts.lane_tails);
  layout.states = memory.take<double>(amounts.states);
  return layout;
}

}  // namespace

uint32_t padded_tails(uint32_t block_count) {
  return block_count * block_cycles + block_cycles - 1;
}

Amounts count_amounts(ImageView const& view, uint32_t lanes) {
  Amounts amounts{.setpoint = count_port(view, PortKind::setpoint, lanes),
                  .additional_interface = count_port(view, PortKind::additional_interface, lanes),
                  .velocity = count_port(view, PortKind::velocity, lanes),
                  .axes = view.axes.count,
                  .filters = view.filters.count,
                  .kernels = uint64_t{view.kernels.count} + 1,
                  .tails = padded_tails(blocks_of(0)),
                  .slots = view.slots.count,
                  .channels = view.groups.count,
                  .members = view.members.count,
                  .banks = view.banks.count,
                  .choices = view.choices.count,
                  .controls = view.controls.count,
                  .stages = view.stages.count};
  for (uint32_t i = 0; i < view.kernels.count; ++i) {
    amounts.tails += padded_tails(blocks_of(view.kernels[i][field::kernel::tail_count]));
  }
  return amounts;
}

Layout lay_out(Amounts const& amounts) {
  Reservation memory;
  Layout layout;
  layout.object = memory.take<axisrt>(1);
  layout.setpoint = lay_out_port(amounts.setpoint, memory);
  layout.additional_interface = lay_out_port(amounts.additional_interface, memory);
  layout.velocity = lay_out_port(amounts.velocity, memory);
  layout.axes = memory.take<Axis>(amounts.axes);
  layout.filters = memory.take<Filter>(amounts.filters);
  layout.kernels = memory.take<Kernel>(amounts.kernels);
  layout.tails = memory.take<double>(amounts.tails);
  layout.slots = memory.take<Slot>(amounts.slots);
  layout.slot_switches = memory.take<SlotSwitch>(amounts.slots);
  layout.channels = memory.take<Channel>(amounts.channels);
  layout.channel_states = memory.take<ChannelState>(amounts.channels);
  layout.members = memory.take<Slot const*>(amounts.members);
  layout.banks = memory.take<Bank>(amounts.banks);
  layout.choices = memory.take<Kernel const*>(amounts.choices);
  layout.controls = memory.take<Control>(amounts.controls);
  layout.stages = memory.take<Stage>(amounts.stages);
  layout.stage_in = memory.take<double>(amounts.stages);
  layout.stage_out = memory.take<double>(amounts.stages);
  layout.stage_status = memory.take<uint8_t>(amounts.stages);
  layout.additive_velocities = memory.take<double>(amounts.controls);
  layout.change = memory.take<Change>(1);
  layout.shadow = memory.take<double>(amounts.axes > amounts.stages ? amounts.axes : amounts.stages);
  layout.changing_outputs = memory.take<double>(amounts.axes);
  layout.size = memory.end();
  return layout;
}

}  // namespace axisc::runtime
