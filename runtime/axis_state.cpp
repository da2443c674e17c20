#include "axisrt.h"
#include "runtime/double_bits.hpp"
#include "runtime/runtime_object.hpp"

axisrt_status axisrt_get_axis_state(axisrt const* runtime, uint32_t axis, axisrt_axis_state* state) {
  if (runtime == nullptr || state == nullptr || axis >= runtime->axis_count) return AXISRT_BAD_ARGUMENT;
  axisc::runtime::ChainState const& chain = runtime->setpoint.states[axis];
  axisc::runtime::Chain const& filters_in_series = runtime->setpoint.chains[axis];
  axisc::runtime::Slot const* const before = filters_in_series.before;
  axisc::runtime::Slot const* const behind = filters_in_series.behind;
  uint32_t const standard = filters_in_series.filter_count;
  uint32_t const filters = standard + (before != nullptr ? 1 : 0) + (behind != nullptr ? 1 : 0);
  bool const reset_done = chain.reset_done != 0;
  double const distance = axisc::runtime::magnitude(chain.input - chain.output);

  *state = axisrt_axis_state{};
  state->unfiltered = chain.input;
  state->filtered = chain.output;
  for (uint32_t i = 0; i < filters; ++i) state->filter_output[i] = chain.filter_output[i];
  state->filters = filters;
  state->filters_on = (1U << filters) - 1U;
  state->kernel = AXISRT_NO_KERNEL;
  if (axisc::runtime::Slot const* const slot = before != nullptr ? before : behind; slot != nullptr) {
    auto const kernel = static_cast<uint32_t>(slot->state->to - runtime->kernels);
    bool const works = kernel < runtime->kernel_count;
    if (works) state->kernel = kernel;
    uint32_t const place = (before != nullptr ? 0U : standard) % AXISRT_MOST_FILTERS;
    if (!works) state->filters_on &= ~(1U << place);
    state->fading = axisc::runtime::is_fading(*slot->state) ? 1 : 0;
  }
  state->settled = reset_done && distance <= runtime->axes[axis].position_window ? 1 : 0;
  state->reset_done = reset_done ? 1 : 0;
  return AXISRT_OK;
}
