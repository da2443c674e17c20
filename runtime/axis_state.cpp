#include "axisrt.h"
#include "runtime/double_bits.hpp"
#include "runtime/runtime_object.hpp"

axisrt_status axisrt_get_axis_state(axisrt const* runtime, uint32_t axis, axisrt_axis_state* state) {
  if (runtime == nullptr || state == nullptr || axis >= runtime->axis_count) return AXISRT_BAD_ARGUMENT;
  axisc::runtime::ChainState const& chain = runtime->setpoint.states[axis];
  uint32_t const filters = runtime->setpoint.chains[axis].filter_count;
  bool const reset_done = chain.reset_done != 0;
  double const distance = axisc::runtime::magnitude(chain.input - chain.output);

  *state = axisrt_axis_state{};
  state->unfiltered = chain.input;
  state->filtered = chain.output;
  for (uint32_t i = 0; i < filters; ++i) state->filter_output[i] = chain.filter_output[i];
  state->filters = filters;
  state->filters_on = (1U << filters) - 1U;
  state->settled = reset_done && distance <= runtime->axes[axis].position_window ? 1 : 0;
  state->reset_done = reset_done ? 1 : 0;
  return AXISRT_OK;
}
