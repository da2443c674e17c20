#include "axisrt.h"
#include "runtime/control_word.hpp"
#include "runtime/runtime_object.hpp"

namespace axisc::runtime {
namespace {

axisrt_status step_port(axisrt const& runtime, Port const& port, double const* in, double* out,
                        uint8_t* status) {
  CycleArithmetic const arithmetic;
  return static_cast<axisrt_status>(runtime.instructions->step(port, in, out, status));
}

}  // namespace
}  // namespace axisc::runtime

axisrt_status axisrt_step(axisrt* runtime, double const* in, double* out, uint8_t* status) {
  if (runtime == nullptr || in == nullptr || out == nullptr) return AXISRT_BAD_ARGUMENT;
  return axisc::runtime::step_port(*runtime, runtime->setpoint.port, in, out, status);
}

axisrt_status axisrt_step_interface(axisrt* runtime, double const* in, double* out, uint8_t* status) {
  if (runtime == nullptr || in == nullptr || out == nullptr) return AXISRT_BAD_ARGUMENT;
  return axisc::runtime::step_port(*runtime, runtime->additional_interface.port, in, out, status);
}
