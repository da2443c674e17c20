#include "axisrt.h"
#include "runtime/double_bits.hpp"
#include "runtime/runtime_object.hpp"

namespace axisc::runtime {
namespace {

constexpr uint32_t mode_direct = 1;
constexpr uint32_t mode_indirect = 2;

double input_of(uint32_t mode, uint32_t axis, axisrt_velocities const& in) {
  switch (mode) {
    case mode_direct:
      return (in.v_direct != nullptr ? in.v_direct : in.v_motor)[axis];
    case mode_indirect:
      return in.v_motor[axis];
    default:
      return in.v_set[axis];
  }
}

/// v, or the limit with the sign of v.
double limited(double v, double limit) {
  constexpr uint64_t sign = 0x8000'0000'0000'0000U;
  uint64_t const bound = std::bit_cast<uint64_t>(limit) | (std::bit_cast<uint64_t>(v) & sign);
  return select(mask_if_within(v, limit), v, std::bit_cast<double>(bound));
}

/// v_add = - sum of weight_i stage_i; 0 before a reset.
Mask step_control(Control const& control, axisrt_velocities const& in, double& v_add) {
  Mask worst = AXISRT_OK;
  double sum = 0;
  for (uint32_t i = 0; i < control.stage_count; ++i) {
    Stage const& stage = control.stages[i];
    ChainState& state = control.stage_states[i];
    worst = worse(worst, step_chain(stage.chain, state, input_of(stage.mode, control.axis, in)));
    sum -= keep(state.reset_done, stage.weight * state.output);
  }
  v_add = limited(sum, control.limit);
  return worst;
}

}  // namespace
}  // namespace axisc::runtime

axisrt_status axisrt_step_velocity(axisrt* runtime, axisrt_velocities const* in, double* v_add,
                                   double* increments, uint8_t* status) {
  using namespace axisc::runtime;
  if (runtime == nullptr || in == nullptr || v_add == nullptr || in->size != sizeof(axisrt_velocities)) {
    return AXISRT_BAD_ARGUMENT;
  }
  if (in->v_set == nullptr || in->v_motor == nullptr) return AXISRT_BAD_ARGUMENT;
  Mask worst = AXISRT_OK;
  for (uint32_t i = 0; i < runtime->control_count; ++i) {
    Control const& control = runtime->controls[i];
    if (control.source != i) continue;
    Mask const happened = step_control(control, *in, runtime->additive_velocities[i]);
    if (status != nullptr) status[control.axis] = static_cast<uint8_t>(happened);
    worst = worse(worst, happened);
  }
  uint32_t next = 0;
  for (uint32_t axis = 0; axis < runtime->axis_count; ++axis) {
    bool const controlled = next < runtime->control_count && runtime->controls[next].axis == axis;
    double const v = controlled ? runtime->additive_velocities[runtime->controls[next].source] : 0;
    bool const own = controlled && runtime->controls[next].source == next;
    v_add[axis] = v;
    if (increments != nullptr) increments[axis] = controlled ? v * runtime->controls[next].scale : 0;
    if (status != nullptr && !own) status[axis] = AXISRT_OK;
    next += controlled ? 1 : 0;
  }
  return static_cast<axisrt_status>(worst);
}
