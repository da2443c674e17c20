// One lane of a group, as everything outside the cycle sees it.
#pragma once

#include "runtime/double_bits.hpp"
#include "runtime/runtime_object.hpp"

#include <bit>
#include <stddef.h>
#include <stdint.h>

namespace axisc::runtime {

/// Value base + sum of a signal.
struct Value {
  double base, sum;
};

[[nodiscard]] inline double rounded(Value const& value) {
  return value.base + value.sum;
}

/// Coefficients as they are executed: g = p + q.
struct SectionCoefficients {
  double p, g, k, b;
};

/// The state and the constants of a line.
class Lane {
 public:
  Lane(LinePort const& port, LineChain const& line)
      : batch_(port.port.batches[line.batch]),
        parts_(batch_.states + static_cast<size_t>(line.group) * batch_.state_stride),
        constants_(batch_.constants + static_cast<size_t>(line.group) * batch_.operation_count),
        lane_(line.lane) {}

  /// A double of the group's own pieces (GroupParts).
  [[nodiscard]] double& part(uint32_t index) const { return parts_[index * batch_.width + lane_]; }
  [[nodiscard]] bool reset_done() const { return std::bit_cast<uint64_t>(part(GroupParts::reset_done)) != 0; }
  void set_reset_done() const {
    if (!reset_done()) batch_.state->never_reset -= 1;
    part(GroupParts::reset_done) = std::bit_cast<double>(all_set);
  }

  [[nodiscard]] Operation const& operation(Filter const& filter) const {
    return batch_.operations[filter.operation];
  }
  [[nodiscard]] double& state(Filter const& filter, uint32_t index) const {
    return part(operation(filter).first_state + index);
  }
  /// e and r of a section.
  [[nodiscard]] double& e(Filter const& filter, uint32_t section) const {
    return state(filter, 2 * (filter.first_section + section));
  }
  [[nodiscard]] double& r(Filter const& filter, uint32_t section) const {
    return state(filter, 2 * (filter.first_section + section) + 1);
  }
  /// s, 1 - s, the rest of 1 - s; not for passing filters.
  [[nodiscard]] double share(Filter const& filter, uint32_t index) const {
    return constants_[filter.operation][index * batch_.width + lane_];
  }
  [[nodiscard]] SectionCoefficients section(Filter const& filter, uint32_t index) const {
    uint32_t const shares = filter.kind == FilterKind::passing ? 0 : 3;
    size_t const width = batch_.width;
    double const* const first =
        constants_[filter.operation] + (shares + size_t{4} * (filter.first_section + index)) * width + lane_;
    return {.p = first[0], .g = first[width], .k = first[2 * width], .b = first[3 * width]};
  }

 private:
  Batch const& batch_;
  double* parts_;
  double const* const* constants_;
  uint32_t lane_;
};

/// A double per lane of a slot's piece (SlotParts).
[[nodiscard]] inline double& slot_part(Slot const& slot, uint32_t index) {
  return slot.parts[static_cast<size_t>(index) * slot.width + slot.lane];
}

[[nodiscard]] inline bool is_fading(Slot const& slot) {
  return slot.group->fade_position[slot.lane] < slot.group->fade_length[slot.lane];
}

/// True where switching kernels cannot be seen in the output: no increment to speak of for as many cycles as
/// the slot's longest kernel remembers. Cost: that many cycles.
[[nodiscard]] bool is_at_rest(Slot const& slot);

/// The steady state of line `index` for a signal that has always been `position`.
void reset_line(axisrt const& runtime, LinePort const& port, uint32_t index, double position);

/// The steady state for any constant signal; a fade has ended.
void reset_slot(Slot const& slot);

/// Begins to work with `kernel`; without a fade where `fade_cycles` is 0. Expects that none runs. Cost: the
/// tails of a slot's longest kernel.
void switch_slot(Slot const& slot, Kernel const* kernel, uint32_t fade_cycles);

/// Puts the tails of a lane's kernels, the one that works and the one before, where they are applied from.
void write_tails_of_lane(SlotGroup& group, uint32_t lane, uint32_t width);

/// Chooses how a group works whose lanes are all in the steady state.
void start_at_rest(SlotGroup& group, uint32_t width);

/// The output of a filter for a signal that has always been `in`. Does not touch the states.
[[nodiscard]] Value steady_output(Lane const& lane, Filter const& filter, Value const& in);

/// The output of a filter in the latest cycle, if its input was `in`.
[[nodiscard]] Value latest_output(Lane const& lane, Filter const& filter, Value const& in);

}  // namespace axisc::runtime
