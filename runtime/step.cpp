#include "axisrt.h"
#include "runtime/change.hpp"
#include "runtime/control_word.hpp"
#include "runtime/lane.hpp"
#include "runtime/recorder.hpp"

namespace axisc::runtime {
namespace {

/// Both runtimes get the same setpoints: y = y_before + w (y_new - y_before) where the axis was reset.
uint64_t step_both(axisrt const& runtime, axisrt const& before, LinePort axisrt::*port, Call call) {
  Change const& change = *runtime.change;
  before.instructions->step((before.*port).port, call.in, change.shadow, nullptr);
  uint64_t const worst = runtime.instructions->step((runtime.*port).port, call.in, call.out, call.status);
  double const w = weight_of(change);
  for (uint32_t i = 0; i < runtime.axis_count; ++i) {
    bool const filtered = Lane(runtime.*port, (runtime.*port).lines[i]).reset_done();
    double const blend = change.shadow[i] + w * (call.out[i] - change.shadow[i]);
    if (filtered && change.position < change.length) call.out[i] = blend;
  }
  return worst;
}

/// The image is being changed, or a recorder is running.
bool is_changing_or_recorded(axisrt const& runtime) {
  return runtime.recorder != nullptr || runtime.change->begun != 0;
}

AXISRT_APART axisrt_status execute_in_own_arithmetic(axisrt const& runtime, Port const& port, Call call) {
  return in_cycle_arithmetic([&] {
    return static_cast<axisrt_status>(runtime.instructions->step(port, call.in, call.out, call.status));
  });
}

/// Filters alone raise no flag but the one that stays: bad setpoints are sorted out as integers, no number is
/// subnormal, and none gets too large (lanes/sections_def.hpp). So the control word needs to be read only
/// once.
AXISRT_INLINE axisrt_status execute(axisrt const& runtime, Port const& port, Call call) {
  if (!CycleArithmetic::is_in_force()) return execute_in_own_arithmetic(runtime, port, call);
  return static_cast<axisrt_status>(runtime.instructions->step(port, call.in, call.out, call.status));
}

axisrt_status execute_in_change(axisrt const& runtime, LinePort axisrt::*port, Call call) {
  axisrt const* const before = changes_from(runtime);
  if (before == nullptr) return execute(runtime, (runtime.*port).port, call);
  return static_cast<axisrt_status>(
      in_cycle_arithmetic([&] { return step_both(runtime, *before, port, call); }));
}

AXISRT_APART axisrt_status step_slow_path(axisrt const& runtime, LinePort axisrt::*port, uint32_t kind,
                                          Call call) {
  if (runtime.recorder == nullptr) return execute_in_change(runtime, port, call);
  EntrySizes const& sizes = runtime.recorder->sizes;
  Entry entry(runtime.recorder, kind, 0, kind == axrd_step ? sizes.step : sizes.step_interface);
  entry.put(call.in, runtime.axis_count);
  axisrt_status const worst = execute_in_change(runtime, port, call);
  entry.put(call.out, runtime.axis_count);
  entry.put(call.status, runtime.axis_count);
  entry.finish(call.status != nullptr ? axrd_has_status : 0, worst);
  return worst;
}

AXISRT_APART axisrt_status step_setpoints_slow_path(axisrt const& runtime, Call call) {
  bool const changes = changes_from(runtime) != nullptr;
  if (changes) advance(*runtime.change);
  axisrt_status const worst = step_slow_path(runtime, &axisrt::setpoint, axrd_step, call);
  if (changes) {
    for (uint32_t i = 0; i < runtime.axis_count; ++i) runtime.change->outputs[i] = call.out[i];
  }
  return worst;
}

}  // namespace
}  // namespace axisc::runtime

// Outputs are written by way of a structure.
// NOLINTBEGIN(readability-non-const-parameter)
axisrt_status axisrt_step(axisrt* runtime, double const* in, double* out, uint8_t* status) {
  using namespace axisc::runtime;
  if (runtime == nullptr || in == nullptr || out == nullptr) return AXISRT_BAD_ARGUMENT;
  Call const call{.in = in, .out = out, .status = status};
  return is_changing_or_recorded(*runtime) ? step_setpoints_slow_path(*runtime, call)
                                           : execute(*runtime, runtime->setpoint.port, call);
}

axisrt_status axisrt_step_interface(axisrt* runtime, double const* in, double* out, uint8_t* status) {
  using namespace axisc::runtime;
  if (runtime == nullptr || in == nullptr || out == nullptr) return AXISRT_BAD_ARGUMENT;
  Call const call{.in = in, .out = out, .status = status};
  return is_changing_or_recorded(*runtime)
             ? step_slow_path(*runtime, &axisrt::additional_interface, axrd_step_interface, call)
             : execute(*runtime, runtime->additional_interface.port, call);
}
// NOLINTEND(readability-non-const-parameter)
