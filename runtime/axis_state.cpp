#include "axisrt.h"
#include "runtime/change.hpp"
#include "runtime/control_word.hpp"
#include "runtime/lane.hpp"

namespace axisc::runtime {
namespace {

void describe(axisrt const& runtime, uint32_t axis, axisrt_axis_state& state) {
  LineChain const& line = runtime.setpoint.lines[axis];
  Lane const lane(runtime.setpoint, line);
  state = axisrt_axis_state{};
  state.unfiltered = lane.part(GroupParts::input);
  bool const changes = changes_from(runtime) != nullptr && lane.reset_done();
  state.filtered = changes ? runtime.change->outputs[axis] : lane.part(GroupParts::output);
  state.kernel = AXISRT_NO_KERNEL;
  state.reset_done = lane.reset_done() ? 1 : 0;

  // The filters' outputs are not stored in the cycle: they follow from their states.
  Value value{.base = state.unfiltered, .sum = 0};
  auto const put = [&](bool works) {
    state.filter_output[state.filters] = rounded(value);
    if (works) state.filters_on |= 1U << state.filters;
    state.filters += 1;
  };
  auto const put_slot = [&](Slot const& slot) {
    value.sum -= slot_part(slot, SlotParts::removed);
    auto const kernel = static_cast<uint32_t>(slot.group->kernel[slot.lane] - runtime.kernels);
    bool const works = kernel < runtime.kernel_count;
    if (works) state.kernel = kernel;
    state.fading = is_fading(slot) ? 1 : 0;
    put(works);
  };
  if (line.before != nullptr) put_slot(*line.before);
  for (uint32_t i = 0; i < line.filter_count; ++i) {
    value = latest_output(lane, runtime.filters[line.first_filter + i], value);
    put(true);
  }
  if (line.behind != nullptr) put_slot(*line.behind);

  double const distance = magnitude(state.unfiltered - state.filtered);
  bool const settled = state.reset_done != 0 && distance <= runtime.axes[axis].position_window;
  state.settled = settled ? 1 : 0;
}

}  // namespace
}  // namespace axisc::runtime

axisrt_status axisrt_get_axis_state(axisrt const* runtime, uint32_t axis, axisrt_axis_state* state) {
  using namespace axisc::runtime;
  if (runtime == nullptr || state == nullptr || axis >= runtime->axis_count) return AXISRT_BAD_ARGUMENT;
  return in_plain_arithmetic([&] {
    describe(*runtime, axis, *state);
    return AXISRT_OK;
  });
}
