// Everything that cycles, commands and resets change in a runtime, number by number in one order, so that it
// can be copied, written and read. Derived values (tails side by side) and those that the next cycle
// overwrites are left out.
#pragma once

#include "runtime/lane.hpp"
#include "runtime/runtime_object.hpp"

#include <stdint.h>

namespace axisc::runtime {

/// Pairs the state of `from` with that of `to`, two runtimes of one image and level, or one and the same. Two
/// that are laid out differently are refused before anything is read where they differ. The visitor has
///     bool number(uint32_t from, uint32_t& to, uint32_t largest);   false: refused, as larger than `largest`
///     bool states(Batch const& from, Batch const& to);              all groups' states; false: refused
template <class Visitor>
class StateWalk {
 public:
  StateWalk(axisrt const& from, axisrt const& to, Visitor& visitor)
      : from_(from), to_(to), visitor_(visitor) {}

  /// False where the layouts differ, or the visitor refused a number; the state of `to` is unusable then.
  [[nodiscard]] bool walk() {
    bool good = from_.slot_count == to_.slot_count && from_.channel_count == to_.channel_count &&
                from_.kernel_count == to_.kernel_count;
    good = good && port(from_.setpoint.port, to_.setpoint.port);
    good = good && port(from_.additional_interface.port, to_.additional_interface.port);
    good = good && port(from_.velocity.port, to_.velocity.port);
    for (uint32_t i = 0; i < from_.slot_count && good; ++i) {
      good = visitor_.number(from_.slots[i].state->on, to_.slots[i].state->on, 1);
    }
    for (uint32_t i = 0; i < from_.channel_count && good; ++i) {
      good = visitor_.number(from_.channels[i].state->bank, to_.channels[i].state->bank,
                             to_.channels[i].bank_count - 1);
    }
    return good;
  }

 private:
  bool port(Port const& from, Port const& to) {
    bool good = from.batch_count == to.batch_count && from.line_count == to.line_count;
    for (uint32_t i = 0; i < from.batch_count && good; ++i) {
      good = batch(from, from.batches[i], to.batches[i]);
    }
    return good;
  }

  bool batch(Port const& port, Batch const& from, Batch const& to) {
    if (!same_layout(from, to)) return false;
    bool good = visitor_.number(from.state->never_reset, to.state->never_reset, port.line_count);
    good = good && visitor_.states(from, to);
    for (uint32_t i = 0; i < from.operation_count && good; ++i) {
      Operation const& one = from.operations[i];
      Operation const& other = to.operations[i];
      if (!same_layout(one, other)) return false;
      good = visitor_.number(one.state->position, other.state->position, one.delay_cycles) &&
             visitor_.number(one.state->group, other.state->group, from.group_count - 1) &&
             visitor_.number(one.state->section, other.state->section,
                             one.section_count > 0 ? one.section_count - 1 : 0);
      if (one.kind != OperationKind::slot) continue;
      for (uint32_t group = 0; group < from.group_count && good; ++group) {
        good = slot(one.slots[group], other.slots[group], from.width);
      }
    }
    return good;
  }

  static bool same_layout(Batch const& a, Batch const& b) {
    return a.width == b.width && a.group_count == b.group_count && a.operation_count == b.operation_count &&
           a.state_stride == b.state_stride;
  }

  static bool same_layout(Operation const& a, Operation const& b) {
    return a.kind == b.kind && a.section_count == b.section_count && a.delay_cycles == b.delay_cycles &&
           a.first_state == b.first_state;
  }

  bool slot(SlotGroup const& from, SlotGroup& to, uint32_t width) {
    if (from.block_count != to.block_count || from.used != to.used) return false;
    auto mode = static_cast<uint32_t>(from.mode);
    bool good = visitor_.number(mode, mode, static_cast<uint32_t>(SlotMode::ramp)) &&
                visitor_.number(from.gathers, to.gathers, 1) &&
                visitor_.number(from.block, to.block, from.block_count - 1) &&
                visitor_.number(from.phase, to.phase, block_cycles - 1) &&
                visitor_.number(from.fading, to.fading, width) &&
                visitor_.number(from.next_ahead, to.next_ahead, 1) &&
                kernel(from.common, to.common, to.block_count);
    if (!good) return false;
    to.mode = static_cast<SlotMode>(mode);
    bool const ramp = to.mode == SlotMode::ramp;
    if (ramp && (to.common == nullptr || to.common->ramp == 0)) return false;
    good = visitor_.number(from.ramp_phase, to.ramp_phase, ramp ? to.common->tail_count - 1 : longest_kernel);
    for (uint32_t lane = 0; lane < width && good; ++lane) {
      good = kernel(from.kernel[lane], to.kernel[lane], to.block_count) && to.kernel[lane] != nullptr &&
             kernel(from.before[lane], to.before[lane], to.block_count) && to.before[lane] != nullptr &&
             visitor_.number(from.fade_length[lane], to.fade_length[lane], longest_fade) &&
             visitor_.number(from.fade_position[lane], to.fade_position[lane], to.fade_length[lane]);
      if (good) write_tails_of_lane(to, lane, width);
    }
    return good;
  }

  /// Kernels by their number, none as the one after the last; they must fit into a history of `blocks`.
  bool kernel(Kernel const* from, Kernel const*& to, uint32_t blocks) {
    uint32_t const none = from_.kernel_count + 1;
    uint32_t number = from == nullptr ? none : static_cast<uint32_t>(from - from_.kernels);
    if (!visitor_.number(number, number, none)) return false;
    to = number == none ? nullptr : to_.kernels + number;
    return to == nullptr || to->block_count <= blocks;
  }

  static constexpr uint32_t longest_kernel = 4096;
  static constexpr uint32_t longest_fade = 4096;

  axisrt const& from_;
  axisrt const& to_;
  Visitor& visitor_;
};

}  // namespace axisc::runtime
