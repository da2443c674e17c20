#include "axisrt.h"
#include "runtime/change.hpp"
#include "runtime/control_word.hpp"
#include "runtime/double_bits.hpp"
#include "runtime/lane.hpp"
#include "runtime/limits.hpp"
#include "runtime/recorder.hpp"

namespace axisc::runtime {
namespace {

constexpr uint32_t mode_direct = 1;
constexpr uint32_t mode_indirect = 2;

double input_of(Stage const& stage, axisrt_velocities const& in) {
  switch (stage.mode) {
    case mode_direct: return (in.v_direct != nullptr ? in.v_direct : in.v_motor)[stage.axis];
    case mode_indirect: return in.v_motor[stage.axis];
    default: return in.v_set[stage.axis];
  }
}

void step_stages(axisrt const& runtime, axisrt_velocities const& in) {
  StageSignals const& signals = runtime.stage_signals;
  for (uint32_t i = 0; i < runtime.stage_count; ++i) signals.in[i] = input_of(runtime.stages[i], in);
  runtime.instructions->step(runtime.velocity.port, signals.in, signals.out, signals.status);
}

/// v, or the limit with the sign of v.
double limited(double v, double limit) {
  constexpr uint64_t sign = 0x8000'0000'0000'0000U;
  uint64_t const bound = std::bit_cast<uint64_t>(limit) | (std::bit_cast<uint64_t>(v) & sign);
  return select(mask_if_within(v, limit), v, std::bit_cast<double>(bound));
}

Mask worse(Mask a, Mask b) {
  return select(mask_if_less(a, b), b, a);
}

/// v_add = - sum of weight_i stage_i; 0 before a reset.
Mask join_stages(axisrt const& runtime, Control const& control, double& v_add) {
  Mask worst = AXISRT_OK;
  double sum = 0;
  for (uint32_t i = control.first_stage; i < control.first_stage + control.stage_count; ++i) {
    Lane const lane(runtime.velocity, runtime.velocity.lines[i]);
    auto const reset_done = std::bit_cast<Mask>(lane.part(GroupParts::reset_done));
    worst = worse(worst, runtime.stage_signals.status[i]);
    sum -= keep(reset_done, runtime.stages[i].weight * runtime.stage_signals.out[i]);
  }
  v_add = limited(on_grid(sum, grid), control.limit);
  return worst;
}

/// The additive velocities of the runtime before, whose controls are the same.
void step_before(axisrt const& before, axisrt_velocities const& in, double* v_add) {
  step_stages(before, in);
  for (uint32_t i = 0; i < before.control_count; ++i) join_stages(before, before.controls[i], v_add[i]);
}

double blended(Change const& change, uint32_t control, double v) {
  return change.shadow[control] + weight_of(change) * (v - change.shadow[control]);
}

/// The outputs of a call, one entry for each axis; increments and statuses may be null.
struct Outputs {
  double* v_add;
  double* increments;
  uint8_t* status;
};

axisrt_status step_controls(axisrt const& runtime, axisrt_velocities const& in, Outputs const& out) {
  CycleArithmetic const arithmetic;
  if (axisrt const* const before = changes_from(runtime)) step_before(*before, in, runtime.change->shadow);
  step_stages(runtime, in);
  Mask worst = AXISRT_OK;
  for (uint32_t i = 0; i < runtime.control_count; ++i) {
    Control const& control = runtime.controls[i];
    if (control.source != i) continue;
    double& v = runtime.additive_velocities[i];
    Mask const happened = join_stages(runtime, control, v);
    if (changes_from(runtime) != nullptr) v = blended(*runtime.change, i, v);
    if (out.status != nullptr) out.status[control.axis] = static_cast<uint8_t>(happened);
    worst = worse(worst, happened);
  }
  uint32_t next = 0;
  for (uint32_t axis = 0; axis < runtime.axis_count; ++axis) {
    bool const controlled = next < runtime.control_count && runtime.controls[next].axis == axis;
    double const v = controlled ? runtime.additive_velocities[runtime.controls[next].source] : 0;
    bool const own = controlled && runtime.controls[next].source == next;
    out.v_add[axis] = v;
    if (out.increments != nullptr) out.increments[axis] = controlled ? v * runtime.controls[next].scale : 0;
    if (out.status != nullptr && !own) out.status[axis] = AXISRT_OK;
    next += controlled ? 1 : 0;
  }
  return static_cast<axisrt_status>(worst);
}

uint32_t flag_if(bool given, uint32_t flag) {
  return given ? flag : 0;
}

axisrt_status record_step(axisrt const& runtime, axisrt_velocities const& in, Outputs const& out) {
  uint32_t const axes = runtime.axis_count;
  Entry entry(runtime.recorder, axrd_step_velocity, 0, runtime.recorder->sizes.step_velocity);
  entry.put(in.v_set, axes);
  entry.put(in.v_motor, axes);
  entry.put(in.v_direct, axes);
  axisrt_status const worst = step_controls(runtime, in, out);
  entry.put(out.v_add, axes);
  entry.put(out.increments, axes);
  entry.put(out.status, axes);
  entry.finish(flag_if(in.v_direct != nullptr, axrd_has_v_direct) |
                   flag_if(out.increments != nullptr, axrd_has_increments) |
                   flag_if(out.status != nullptr, axrd_has_status),
               worst);
  return worst;
}

}  // namespace
}  // namespace axisc::runtime

// Outputs are written by way of a structure.
// NOLINTBEGIN(readability-non-const-parameter)
axisrt_status axisrt_step_velocity(axisrt* runtime, axisrt_velocities const* in, double* v_add,
                                   double* increments, uint8_t* status) {
  using namespace axisc::runtime;
  if (runtime == nullptr || in == nullptr || v_add == nullptr || in->size != sizeof(axisrt_velocities)) {
    return AXISRT_BAD_ARGUMENT;
  }
  if (in->reserved != 0 || in->v_set == nullptr || in->v_motor == nullptr) return AXISRT_BAD_ARGUMENT;
  Outputs const out{.v_add = v_add, .increments = increments, .status = status};
  return runtime->recorder != nullptr ? record_step(*runtime, *in, out) : step_controls(*runtime, *in, out);
}
// NOLINTEND(readability-non-const-parameter)
