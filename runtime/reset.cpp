#include "runtime/reset.hpp"

#include "axisrt.h"
#include "runtime/limits.hpp"
#include "runtime/runtime_object.hpp"

namespace axisc::runtime {
namespace {

/// Slots hold increments only, so that every constant signal passes them unchanged.
void reset_chain(Chain const& chain, ChainState& state, double position) {
  Signal signal{.base = position, .sum = 0, .d = 0};
  double* output = state.filter_output;
  if (chain.before != nullptr) {
    reset_slot(*chain.before);
    *output++ = value_of(signal);
  }
  for (uint32_t i = 0; i < chain.filter_count; ++i) {
    signal = reset_filter(chain.filters[i], signal);
    *output++ = value_of(signal);
  }
  if (chain.behind != nullptr) {
    reset_slot(*chain.behind);
    *output = value_of(signal);
  }
  state.input = position;
  state.output = value_of(signal);
  state.reset_done = all_set;
}

axisrt_status reset_port(axisrt const* runtime, Port const& port, uint32_t axis, double position) {
  if (axis >= runtime->axis_count) return AXISRT_BAD_ARGUMENT;
  if (!is_within(position, largest_position)) return AXISRT_BAD_INPUT;
  reset_chain(port.chains[axis], port.states[axis], position);
  return AXISRT_OK;
}

/// Adds a constant to every signal in a delay, without loss where it is representable.
void shift_ring(Filter const& filter, Signal const& shift) {
  for (uint32_t i = 0; i < filter.delay_cycles; ++i) {
    Signal& signal = filter.ring[i];
    Twofold const base = exact_sum(signal.base, shift.base);
    signal.base = base.high;
    signal.sum += base.low + shift.sum;
  }
}

/// States of sections hold increments only: what moves with the origin are setpoints and delayed signals.
void rebase_chain(Chain const& chain, ChainState& state, double offset) {
  Signal shift{.base = offset, .sum = 0, .d = 0};
  double* output = state.filter_output;
  if (chain.before != nullptr) *output++ += offset;
  for (uint32_t i = 0; i < chain.filter_count; ++i) {
    Filter const& filter = chain.filters[i];
    shift_ring(filter, shift);
    shift = steady_output(filter, shift);
    *output++ += value_of(shift);
  }
  if (chain.behind != nullptr) *output += value_of(shift);
  state.input += offset;
  state.output += value_of(shift);
}

}  // namespace

Signal reset_filter(Filter const& filter, Signal const& in) {
  for (uint32_t i = 0; i < filter.section_count; ++i) filter.states[i] = {.e = 0, .r = 0};
  for (uint32_t i = 0; i < filter.delay_cycles; ++i) filter.ring[i] = in;
  *filter.oldest = 0;
  return steady_output(filter, in);
}

}  // namespace axisc::runtime

axisrt_status axisrt_reset(axisrt* runtime, uint32_t axis, double position) {
  if (runtime == nullptr) return AXISRT_BAD_ARGUMENT;
  return axisc::runtime::reset_port(runtime, runtime->setpoint, axis, position);
}

axisrt_status axisrt_reset_interface(axisrt* runtime, uint32_t axis, double value) {
  if (runtime == nullptr) return AXISRT_BAD_ARGUMENT;
  return axisc::runtime::reset_port(runtime, runtime->additional_interface, axis, value);
}

axisrt_status axisrt_reset_velocity(axisrt* runtime, uint32_t axis, double v_set, double v_motor,
                                    double v_direct) {
  using namespace axisc::runtime;
  if (runtime == nullptr || axis >= runtime->axis_count) return AXISRT_BAD_ARGUMENT;
  double const velocities[] = {v_direct, v_motor, v_set};  // in the order of the modes
  for (double const velocity : velocities) {
    if (!is_within(velocity, largest_position)) return AXISRT_BAD_INPUT;
  }
  for (uint32_t i = 0; i < runtime->control_count; ++i) {
    Control const& control = runtime->controls[i];
    if (control.axis != axis) continue;
    for (uint32_t stage = 0; stage < control.stage_count; ++stage) {
      reset_chain(control.stages[stage].chain, control.stage_states[stage],
                  velocities[control.stages[stage].mode - 1]);
    }
  }
  return AXISRT_OK;
}

axisrt_status axisrt_rebase(axisrt* runtime, uint32_t axis, double offset) {
  using namespace axisc::runtime;
  if (runtime == nullptr || axis >= runtime->axis_count) return AXISRT_BAD_ARGUMENT;
  ChainState& state = runtime->setpoint.states[axis];
  if (state.reset_done == 0) return AXISRT_NOT_RESET;
  if (!is_within(offset, largest_position)) return AXISRT_BAD_INPUT;
  if (!is_within(state.input + offset, largest_position)) return AXISRT_BAD_INPUT;
  rebase_chain(runtime->setpoint.chains[axis], state, offset);
  return AXISRT_OK;
}
