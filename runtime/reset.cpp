#include "axisrt.h"
#include "runtime/change.hpp"
#include "runtime/control_word.hpp"
#include "runtime/lane.hpp"
#include "runtime/limits.hpp"
#include "runtime/recorder.hpp"
#include "runtime/twofold.hpp"

namespace axisc::runtime {
namespace {

void reset_filter(Lane const& lane, Filter const& filter, Value const& in) {
  for (uint32_t i = 0; i < filter.section_count; ++i) {
    lane.e(filter, i) = 0;
    lane.r(filter, i) = r_at_rest;
  }
  if (filter.kind != FilterKind::delay) return;
  for (uint32_t i = 0; i <= filter.delay_cycles; ++i) {
    lane.state(filter, 3 * i) = in.base;
    lane.state(filter, 3 * i + 1) = in.sum;
    lane.state(filter, 3 * i + 2) = 0;
  }
}

/// A call between the cycles, recorded before it is executed.
template <uint32_t Count>
void record_values(axisrt const& runtime, uint32_t kind, uint32_t axis, double const (&values)[Count]) {
  record_call(runtime, {.kind = kind, .flags = 0, .status = AXISRT_OK, .index = axis}, values, Count);
}

axisrt_status reset_port(axisrt const* runtime, LinePort const& port, uint32_t kind, uint32_t axis,
                         double position) {
  if (axis >= runtime->axis_count) return AXISRT_BAD_ARGUMENT;
  if (!is_within(position, largest_position)) return AXISRT_BAD_INPUT;
  record_values(*runtime, kind, axis, {position});
  return in_plain_arithmetic([&] {
    reset_line(*runtime, port, axis, position);
    return AXISRT_OK;
  });
}

/// Adds a constant to every signal in a delay, without loss where it is representable.
void shift_ring(Lane const& lane, Filter const& filter, Value const& shift) {
  if (filter.kind != FilterKind::delay) return;
  for (uint32_t i = 0; i <= filter.delay_cycles; ++i) {
    double& base = lane.state(filter, 3 * i);
    Twofold const shifted = exact_sum(base, shift.base);
    base = shifted.high;
    lane.state(filter, 3 * i + 1) += shifted.low + shift.sum;
  }
}

/// States of sections and slots hold increments only: only setpoints and delayed signals move with the
/// origin.
void rebase_line(axisrt const& runtime, LineChain const& line, Lane const& lane, double offset) {
  double const taken = unless_below(smallest_position, offset);
  Value shift{.base = taken, .sum = 0};
  for (uint32_t i = 0; i < line.filter_count; ++i) {
    Filter const& filter = runtime.filters[line.first_filter + i];
    shift_ring(lane, filter, shift);
    shift = steady_output(lane, filter, shift);
  }
  lane.part(GroupParts::input) += taken;
  lane.part(GroupParts::output) += rounded(shift);
}

}  // namespace

/// Slots hold increments only, so that every constant signal passes them unchanged.
void reset_line(axisrt const& runtime, LinePort const& port, uint32_t index, double position) {
  LineChain const& line = port.lines[index];
  Lane const lane(port, line);
  double const taken = unless_below(smallest_position, position);
  Value value{.base = taken, .sum = 0};
  if (line.before != nullptr) reset_slot(*line.before);
  for (uint32_t i = 0; i < line.filter_count; ++i) {
    Filter const& filter = runtime.filters[line.first_filter + i];
    reset_filter(lane, filter, value);
    value = steady_output(lane, filter, value);
  }
  if (line.behind != nullptr) reset_slot(*line.behind);
  lane.part(GroupParts::input) = taken;
  lane.part(GroupParts::output) = rounded(value);
  lane.set_reset_done();
}

namespace {

void reset_stages(axisrt const& runtime, uint32_t axis, double const* velocities) {
  for (uint32_t i = 0; i < runtime.control_count; ++i) {
    Control const& control = runtime.controls[i];
    if (control.axis != axis) continue;
    for (uint32_t k = 0; k < control.stage_count; ++k) {
      uint32_t const stage = control.first_stage + k;
      reset_line(runtime, runtime.velocity, stage, velocities[runtime.stages[stage].mode - 1]);
    }
  }
}

axisrt_status rebase(axisrt const& runtime, uint32_t axis, double offset) {
  LineChain const& line = runtime.setpoint.lines[axis];
  Lane const lane(runtime.setpoint, line);
  if (!lane.reset_done()) return AXISRT_NOT_RESET;
  if (!is_within(offset, largest_position)) return AXISRT_BAD_INPUT;
  if (!is_within(lane.part(GroupParts::input) + offset, largest_position)) return AXISRT_BAD_INPUT;
  if (axisrt* const before = changes_from(runtime)) {
    axisrt_rebase(before, axis, offset);
    runtime.change->outputs[axis] += offset;
  }
  record_values(runtime, axrd_rebase, axis, {offset});
  rebase_line(runtime, line, lane, offset);
  return AXISRT_OK;
}

}  // namespace
}  // namespace axisc::runtime

axisrt_status axisrt_reset(axisrt* runtime, uint32_t axis, double position) {
  if (runtime == nullptr) return AXISRT_BAD_ARGUMENT;
  if (axisrt* const before = axisc::runtime::changes_from(*runtime)) axisrt_reset(before, axis, position);
  return axisc::runtime::reset_port(runtime, runtime->setpoint, axrd_reset, axis, position);
}

axisrt_status axisrt_reset_interface(axisrt* runtime, uint32_t axis, double value) {
  if (runtime == nullptr) return AXISRT_BAD_ARGUMENT;
  if (axisrt* const before = axisc::runtime::changes_from(*runtime)) {
    axisrt_reset_interface(before, axis, value);
  }
  return axisc::runtime::reset_port(runtime, runtime->additional_interface, axrd_reset_interface, axis,
                                    value);
}

axisrt_status axisrt_reset_velocity(axisrt* runtime, uint32_t axis, double v_set, double v_motor,
                                    double v_direct) {
  using namespace axisc::runtime;
  if (runtime == nullptr || axis >= runtime->axis_count) return AXISRT_BAD_ARGUMENT;
  double const velocities[] = {v_direct, v_motor, v_set};  // in the order of the modes
  for (double const velocity : velocities) {
    if (!is_within(velocity, largest_position)) return AXISRT_BAD_INPUT;
  }
  if (axisrt* const before = changes_from(*runtime)) {
    axisrt_reset_velocity(before, axis, v_set, v_motor, v_direct);
  }
  record_values(*runtime, axrd_reset_velocity, axis, {v_set, v_motor, v_direct});
  return in_plain_arithmetic([&] {
    reset_stages(*runtime, axis, velocities);
    return AXISRT_OK;
  });
}

axisrt_status axisrt_rebase(axisrt* runtime, uint32_t axis, double offset) {
  using namespace axisc::runtime;
  if (runtime == nullptr || axis >= runtime->axis_count) return AXISRT_BAD_ARGUMENT;
  return in_plain_arithmetic([&] { return rebase(*runtime, axis, offset); });
}
