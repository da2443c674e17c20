/* The interface as a C11 program sees it: every function and every structure is used here. */
#include "axisrt.h"

#include <stdint.h>
#include <string.h>

/* Runs the first axis of an image from rest to `target` and gives back where it arrives. */
int c_interface_run(const void* image, size_t image_size, void* memory, size_t memory_size, double target,
                    double* arrived);

_Static_assert(sizeof(axisrt_axis_state) == 72, "the layout of axisrt_axis_state is part of the interface");
_Static_assert(sizeof(axisrt_filter_command) == 40,
               "the layout of axisrt_filter_command is part of the interface");

int c_interface_run(const void* image, size_t image_size, void* memory, size_t memory_size, double target,
                    double* arrived) {
  double in[8] = {0};
  double out[8] = {0};
  uint8_t status[8] = {0};
  size_t needed = 0;
  size_t alignment = 0;
  size_t length = 0;
  uint32_t axis = 0;
  int cycle = 0;
  axisrt* runtime = NULL;
  axisrt* restored = NULL;
  axisrt_recorder* recorder = NULL;
  double bound = 0;
  axisrt_axis_state state;
  axisrt_config config;
  axisrt_velocities velocities;
  axisrt_filter_command command;

  memset(&config, 0, sizeof config);
  config.size = sizeof config;
  config.cycle_time_ns = 1000000;
  config.image = image;
  config.image_size = image_size;
  config.memory = memory;
  config.memory_size = memory_size;

  if (axisrt_abi_version() != AXISRT_ABI_VERSION) return 1;
  if (axisrt_verify(image, image_size) != AXISRT_OK) return 2;
  if (axisrt_memory_size(&config, &needed, &alignment) != AXISRT_OK || needed > memory_size) return 3;
  if (axisrt_create(&config, &runtime) != AXISRT_OK) return 4;
  if (axisrt_cycle_time_ns(runtime) != 1000000 || axisrt_axis_count(runtime) > 8) return 5;
  if (axisrt_image_version(runtime) != 7) return 26;
  if (axisrt_axis_name(runtime, 0, &length)[0] != 'X' || length != 1) return 6;

  for (axis = 0; axis < axisrt_axis_count(runtime); ++axis) {
    if (axisrt_reset(runtime, axis, 0.0) != AXISRT_OK) return 7;
    if (axisrt_has_interface(runtime, axis) && axisrt_reset_interface(runtime, axis, 0.0) != AXISRT_OK)
      return 8;
  }
  if (axisrt_rebase(runtime, 0, 0.0) != AXISRT_OK) return 9;
  in[0] = target;
  for (cycle = 0; cycle < 2000; ++cycle) {
    if (axisrt_step(runtime, in, out, status) != AXISRT_OK || status[0] != AXISRT_OK) return 10;
    if (axisrt_step_interface(runtime, in, out + 4, status) != AXISRT_OK) return 11;
  }
  if (axisrt_get_axis_state(runtime, 0, &state) != AXISRT_OK || state.filtered != out[0]) return 12;
  if (strcmp(axisrt_status_name(AXISRT_OK), "AXISRT_OK") != 0 || strlen(axisrt_status_text(AXISRT_OK)) == 0)
    return 13;
  memset(&velocities, 0, sizeof velocities);
  velocities.size = sizeof velocities;
  velocities.v_set = in;
  velocities.v_motor = in;
  if (axisrt_has_position_control(runtime, 0)) return 14;
  if (axisrt_reset_velocity(runtime, 0, 0.0, 0.0, 0.0) != AXISRT_OK) return 15;
  if (axisrt_step_velocity(runtime, &velocities, out + 4, NULL, status) != AXISRT_OK || out[4] != 0)
    return 16;
  memset(&command, 0, sizeof command);
  command.size = sizeof command;
  command.action = AXISRT_ACTION_ON;
  command.keywords = AXISRT_KEYWORD_ORDER;
  command.order = axisrt_order_of_time(runtime, 20000.0);
  if (command.order != 20 || axisrt_group_count(runtime) != 0) return 17;
  if (axisrt_command(runtime, 0, &command) != AXISRT_BAD_ARGUMENT) return 18;
  if (axisrt_group_name(runtime, 0, &length)[0] != '\0' || length != 0) return 19;
  if (axisrt_axis_error_bound(runtime, 0, 1000.0, &bound) != AXISRT_OK || !(bound > 0)) return 20;
  if (axisrt_recorder_size(runtime, &config, 10, &length) != AXISRT_OK) return 21;
  config.memory = (char*)memory + memory_size / 2;
  config.memory_size = memory_size / 2;
  if (length > config.memory_size) return 22;
  if (axisrt_recorder_start(runtime, &config, 10, &recorder) != AXISRT_OK) return 23;
  axisrt_recorder_stop(recorder);
  if (axisrt_recorder_dump(recorder, NULL, 0, &length) != AXISRT_MEMORY_TOO_SMALL || length == 0) return 24;
  if (axisrt_restore(&config, image, image_size, &restored) != AXISRT_BAD_RECORDING) return 25;
  *arrived = out[0];
  return 0;
}
