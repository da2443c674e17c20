#include "axisrt.h"
#include "runtime/double_bits.hpp"
#include "runtime/runtime_object.hpp"

namespace axisc::runtime {
namespace {

axisrt_status step_port(uint32_t axis_count, Port const& port, double const* in, double* out,
                        uint8_t* status) {
  Mask worst = AXISRT_OK;
  for (uint32_t axis = 0; axis < axis_count; ++axis) {
    ChainState& state = port.states[axis];
    double const setpoint = in[axis];
    Mask const happened = step_chain(port.chains[axis], state, setpoint);
    out[axis] = select(state.reset_done, state.output, keep(mask_if_finite(setpoint), setpoint));
    if (status != nullptr) status[axis] = static_cast<uint8_t>(happened);
    worst = worse(worst, happened);
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
