#include "axisrt.h"
#include "runtime/change.hpp"
#include "runtime/control_word.hpp"
#include "runtime/lane.hpp"
#include "runtime/recorder.hpp"

namespace axisc::runtime {
namespace {

/// Both runtimes get the same setpoints: y = y_before + w (y_new - y_before) where the axis was reset.
uint64_t step_both(axisrt const& runtime, axisrt const& before, LinePort axisrt::*port, Call const& call) {
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

axisrt_status execute_port(axisrt const& runtime, LinePort axisrt::*port, Call const& call) {
  CycleArithmetic const arithmetic;
  axisrt const* const before = changes_from(runtime);
  uint64_t const worst =
      before != nullptr ? step_both(runtime, *before, port, call)
                        : runtime.instructions->step((runtime.*port).port, call.in, call.out, call.status);
  return static_cast<axisrt_status>(worst);
}

axisrt_status step_port(axisrt const& runtime, LinePort axisrt::*port, uint32_t kind, Call const& call) {
  if (runtime.recorder == nullptr) return execute_port(runtime, port, call);
  EntrySizes const& sizes = runtime.recorder->sizes;
  Entry entry(runtime.recorder, kind, 0, kind == axrd_step ? sizes.step : sizes.step_interface);
  entry.put(call.in, runtime.axis_count);
  axisrt_status const worst = execute_port(runtime, port, call);
  entry.put(call.out, runtime.axis_count);
  entry.put(call.status, runtime.axis_count);
  entry.finish(call.status != nullptr ? axrd_has_status : 0, worst);
  return worst;
}

}  // namespace
}  // namespace axisc::runtime

axisrt_status axisrt_step(axisrt* runtime, double const* in, double* out, uint8_t* status) {
  using namespace axisc::runtime;
  if (runtime == nullptr || in == nullptr || out == nullptr) return AXISRT_BAD_ARGUMENT;
  bool const changes = changes_from(*runtime) != nullptr;
  if (changes) advance(*runtime->change);
  axisrt_status const worst =
      step_port(*runtime, &axisrt::setpoint, axrd_step, {.in = in, .out = out, .status = status});
  if (changes) {
    for (uint32_t i = 0; i < runtime->axis_count; ++i) runtime->change->outputs[i] = out[i];
  }
  return worst;
}

axisrt_status axisrt_step_interface(axisrt* runtime, double const* in, double* out, uint8_t* status) {
  using namespace axisc::runtime;
  if (runtime == nullptr || in == nullptr || out == nullptr) return AXISRT_BAD_ARGUMENT;
  return step_port(*runtime, &axisrt::additional_interface, axrd_step_interface,
                   {.in = in, .out = out, .status = status});
}
