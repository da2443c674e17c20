/* The motion of motion.c for axisrt_c: its calls, under the names of axisrt's. */
#include "tests/bare_metal/motion_c99.h"

#include <string.h>

/* The bank that the command's parameters name. */
static axisrt_status command_by_bank(axisrt_c* runtime, uint32_t group,
                                     axisrt_filter_command const* command) {
  uint32_t bank = 0;
  for (bank = 0; bank < axisrt_c_bank_count(runtime, group); ++bank) {
    axisrt_c_bank_parameters parameters = {0, 0, 0, 0, 0};
    axisrt_c_get_bank(runtime, group, bank, &parameters);
    if (parameters.keywords == command->keywords && parameters.order == command->order) break;
  }
  return (axisrt_status)axisrt_c_command(runtime, group, (axisrt_c_action)command->action, bank);
}

static axisrt_status step_velocity(axisrt_c* runtime, axisrt_velocities const* in, double* v_add,
                                   double* increments, uint8_t* status) {
  return (axisrt_status)axisrt_c_step_velocity(runtime, in->v_set, in->v_motor, in->v_direct, v_add,
                                               increments, status);
}

#define axisrt axisrt_c
#define axisrt_command command_by_bank
#define axisrt_step_velocity step_velocity
#define axisrt_step axisrt_c_step
#define axisrt_step_interface axisrt_c_step_interface
#define axisrt_reset axisrt_c_reset
#define axisrt_reset_interface axisrt_c_reset_interface
#define axisrt_reset_velocity axisrt_c_reset_velocity
#define axisrt_axis_count axisrt_c_axis_count
#define axisrt_group_count axisrt_c_group_count
#define motion_execute motion_execute_c99
#include "tests/bare_metal/motion.c"
