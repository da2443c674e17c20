/* The recorder: all axes move until a setpoint jumps; the last 200 cycles before that are written to a file,
 * which `axisc replay IMAGE RECORDING` executes again, bit for bit.
 *
 *   record IMAGE RECORDING / */
#include "axisrt.h"
#include "image_file.h"

#include <stdio.h>
#include <stdlib.h>

enum { cycle_time_ns = 1000000, most_axes = 64, recorded_cycles = 200, jump = 500 };

static int save(const axisrt_recorder* recorder, const char* path) {
  size_t size = 0;
  void* bytes = NULL;
  FILE* file = NULL;
  int good = 0;
  axisrt_recorder_dump(recorder, NULL, 0, &size); /* says how long it is */
  bytes = malloc(size);
  if (bytes != NULL && axisrt_recorder_dump(recorder, bytes, size, &size) == AXISRT_OK)
    file = fopen(path, "wb");
  if (file != NULL) good = fwrite(bytes, 1, size, file) == size && fclose(file) == 0;
  free(bytes);
  return good;
}

int main(int argc, char* argv[]) {
  static double setpoint[most_axes], filtered[most_axes];
  image_file image = {NULL, 0};
  axisrt_config config = {0}, recording = {0};
  axisrt* runtime = NULL;
  axisrt_recorder* recorder = NULL;
  size_t alignment = 0;
  axisrt_status status = AXISRT_OK;
  int cycle = 0;
  if (argc != 3 || !load_image_file(argv[1], &image)) return 2;
  config.size = sizeof config;
  config.cycle_time_ns = cycle_time_ns;
  config.image = image.bytes;
  config.image_size = image.size;
  status = axisrt_memory_size(&config, &config.memory_size, &alignment);
  if (status == AXISRT_OK) config.memory = aligned_memory(config.memory_size);
  if (status == AXISRT_OK) status = axisrt_create(&config, &runtime);
  if (status == AXISRT_OK && axisrt_axis_count(runtime) > most_axes) status = AXISRT_BAD_ARGUMENT;
  for (uint32_t axis = 0; status == AXISRT_OK && axis < axisrt_axis_count(runtime); ++axis) {
    status = axisrt_reset(runtime, axis, 0);
  }
  /* The recorder has memory of its own; image and cycle time are those of the runtime. */
  recording = config;
  if (status == AXISRT_OK)
    status = axisrt_recorder_size(runtime, &recording, recorded_cycles, &recording.memory_size);
  if (status == AXISRT_OK) recording.memory = aligned_memory(recording.memory_size);
  if (status == AXISRT_OK) status = axisrt_recorder_start(runtime, &recording, recorded_cycles, &recorder);
  for (cycle = 0; status == AXISRT_OK; ++cycle) {
    for (int axis = 0; axis < most_axes; ++axis) setpoint[axis] = cycle < jump ? 10.0 * cycle : 1e7;
    status = axisrt_step(runtime, setpoint, filtered, NULL);
  }
  printf("cycle %d: %s\n", cycle - 1, axisrt_status_name(status));
  axisrt_recorder_stop(recorder); /* in the cycle; the dump below may be another task's */
  return status == AXISRT_IMPLAUSIBLE && save(recorder, argv[2]) ? 0 : 1;
}
