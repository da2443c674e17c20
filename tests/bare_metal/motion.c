#include "tests/bare_metal/motion.h"

#include <string.h>

static uint64_t bits_of(double value) {
  uint64_t bits = 0;
  memcpy(&bits, &value, sizeof bits);
  return bits;
}

/* Whole numbers with changing velocity: exact everywhere, without a mathematical library. */
static double position(int cycle, uint32_t axis) {
  return (double)(cycle * (cycle % 50) * (int)(axis + 1)) / 4.0;
}

static void command(axisrt* runtime, int cycle, motion_output output, void* context) {
  axisrt_filter_command filters;
  uint32_t group = 0;
  memset(&filters, 0, sizeof filters);
  filters.size = sizeof filters;
  filters.action = cycle % 80 == 20 ? AXISRT_ACTION_ON : AXISRT_ACTION_OFF;
  filters.keywords = AXISRT_KEYWORD_ORDER;
  filters.order = 60;
  for (group = 0; group < axisrt_group_count(runtime); ++group) {
    output(context, (uint64_t)axisrt_command(runtime, group, &filters));
  }
}

static void one_cycle(axisrt* runtime, int cycle, motion_output output, void* context) {
  double in[motion_most_axes] = {0};
  double out[3][motion_most_axes] = {{0}};
  double increments[motion_most_axes] = {0};
  uint8_t status[motion_most_axes] = {0};
  axisrt_velocities velocities;
  uint32_t const axes = axisrt_axis_count(runtime);
  uint32_t axis = 0;
  int port = 0;
  memset(&velocities, 0, sizeof velocities);
  velocities.size = sizeof velocities;
  velocities.v_set = in;
  velocities.v_motor = in;
  for (axis = 0; axis < axes; ++axis) in[axis] = position(cycle, axis);
  output(context, (uint64_t)axisrt_step(runtime, in, out[0], status));
  output(context, (uint64_t)axisrt_step_interface(runtime, in, out[1], status));
  output(context, (uint64_t)axisrt_step_velocity(runtime, &velocities, out[2], increments, status));
  for (port = 0; port < 3; ++port) {
    for (axis = 0; axis < axes; ++axis) output(context, bits_of(out[port][axis]));
  }
}

int motion_execute(axisrt* runtime, motion_output output, void* context) {
  uint32_t const axes = axisrt_axis_count(runtime);
  uint32_t axis = 0;
  int cycle = 0;
  if (axes > motion_most_axes) return motion_most_axes;
  for (axis = 0; axis < axes; ++axis) {
    output(context, (uint64_t)axisrt_reset(runtime, axis, position(0, axis)));
    output(context, (uint64_t)axisrt_reset_interface(runtime, axis, 0.0));
    output(context, (uint64_t)axisrt_reset_velocity(runtime, axis, 0.0, 0.0, 0.0));
  }
  for (cycle = 0; cycle < motion_cycles; ++cycle) {
    if (cycle % 40 == 20) command(runtime, cycle, output, context);
    one_cycle(runtime, cycle, output, context);
  }
  return 0;
}
