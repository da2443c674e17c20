#include "axisrt.h"
#include "runtime/change.hpp"
#include "runtime/control_word.hpp"
#include "runtime/lane.hpp"
#include "runtime/limits.hpp"
#include "runtime/step_distance.hpp"

#include <limits>

namespace axisc::runtime {
namespace {

double error_bound(axisrt const& runtime, uint32_t axis, double velocity) {
  double cycles = 0;
  if (!corner_error(runtime, runtime.setpoint, axis, cycles)) return std::numeric_limits<double>::infinity();
  constexpr double units = 10;  // 0.1 um in a um, 1e-4 degree in 1e-3 degree
  double const seconds = runtime.cycle_time_ns * 1e-9;
  return cycles * (magnitude(velocity) * units * seconds);
}

}  // namespace
}  // namespace axisc::runtime

axisrt_status axisrt_axis_error_bound(axisrt const* runtime, uint32_t axis, double velocity, double* bound) {
  using namespace axisc::runtime;
  if (runtime == nullptr || bound == nullptr || axis >= runtime->axis_count) return AXISRT_BAD_ARGUMENT;
  if (!is_within(velocity, largest_position)) return AXISRT_BAD_INPUT;
  LineChain const& line = runtime->setpoint.lines[axis];
  Slot const* const slot = line.before != nullptr ? line.before : line.behind;
  bool const fades = slot != nullptr && is_fading(*slot);
  if (fades || changes_from(*runtime) != nullptr) return AXISRT_BUSY;
  return in_plain_arithmetic([&] {
    *bound = error_bound(*runtime, axis, velocity);
    return AXISRT_OK;
  });
}
