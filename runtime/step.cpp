#include "axisrt.h"
#include "runtime/double_bits.hpp"
#include "runtime/limits.hpp"
#include "runtime/runtime_object.hpp"

namespace axisc::runtime {
namespace {

Mask larger(Mask a, Mask b) {
  return select(mask_if_less(a, b), b, a);
}

/// One cycle of one chain; returns its output.
double run_chain(Chain const& chain, ChainState& state, double setpoint) {
  Signal signal{.base = setpoint, .sum = 0, .d = setpoint - state.input};
  for (uint32_t i = 0; i < chain.filter_count; ++i) {
    signal = run_filter(chain.filters[i], signal);
    state.filter_output[i] = value_of(signal);
  }
  state.input = setpoint;
  return value_of(signal);
}

/// What happened to the axis, as a number of axisrt_status. Everything that depends on values is selected, not branched to. A chain that was never reset runs too, on
/// the zeros of create, and its output is not used.
Mask step_axis(Chain const& chain, ChainState& state, double in, double& out) {
  Mask const is_reset = state.reset_done;
  Mask const is_good = mask_if_within(in, largest_position);
  Mask const is_repeatable = mask_if_finite(in);

  state.output = run_chain(chain, state, select(is_good & is_reset, in, state.input));
  out = select(is_reset, state.output, keep(is_repeatable, in));
  Mask const status_if_reset = select(is_good, Mask{AXISRT_OK}, Mask{AXISRT_BAD_INPUT});
  return select(is_reset, status_if_reset, Mask{AXISRT_NOT_RESET});
}

axisrt_status step_port(uint32_t axis_count, Port const& port, double const* in, double* out,
                        uint8_t* status) {
  Mask worst = AXISRT_OK;
  for (uint32_t axis = 0; axis < axis_count; ++axis) {
    Mask const happened = step_axis(port.chains[axis], port.states[axis], in[axis], out[axis]);
    if (status != nullptr) status[axis] = static_cast<uint8_t>(happened);
    worst = larger(worst, happened);
  }
  return static_cast<axisrt_status>(worst);
}

}  // namespace
}  // namespace axisc::runtime

axisrt_status axisrt_step(axisrt* runtime, double const* in, double* out, uint8_t* status) {
  if (runtime == nullptr || in == nullptr || out == nullptr) return AXISRT_BAD_ARGUMENT;
  return axisc::runtime::step_port(runtime->axis_count, runtime->setpoint, in, out, status);
}

axisrt_status axisrt_step_interface(axisrt* runtime, double const* in, double* out, uint8_t* status) {
  if (runtime == nullptr || in == nullptr || out == nullptr) return AXISRT_BAD_ARGUMENT;
  return axisc::runtime::step_port(runtime->axis_count, runtime->additional_interface, in, out, status);
}
