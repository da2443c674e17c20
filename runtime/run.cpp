#include "axisrt.h"
#include "runtime/configuration.hpp"
#include "runtime/runtime_object.hpp"

axisrt_status axisrt_run(axisrt* runtime, double const* in, double* out, size_t values, uint8_t* status) {
  using namespace axisc::runtime;
  if (runtime == nullptr || in == nullptr || out == nullptr) return AXISRT_BAD_ARGUMENT;
  size_t const axes = runtime->axis_count;
  if (axes == 0 || values % axes != 0 || values > SIZE_MAX / sizeof(double)) return AXISRT_BAD_ARGUMENT;
  Block const inputs{.first = in, .size = values * sizeof(double)};
  Block const outputs{.first = out, .size = inputs.size};
  Block const statuses{.first = status, .size = status == nullptr ? 0 : values};
  if ((in != out && overlap(inputs, outputs)) || overlap(inputs, statuses) || overlap(outputs, statuses)) {
    return AXISRT_BAD_ARGUMENT;
  }
  axisrt_status worst = AXISRT_OK;
  for (size_t row = 0; row < values; row += axes) {
    axisrt_status const result =
        axisrt_step(runtime, in + row, out + row, status == nullptr ? nullptr : status + row);
    if (result > worst) worst = result;
  }
  return worst;
}
