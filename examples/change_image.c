/* Another image while the axes move: prepared beside the one in use, warmed up in its shadow, faded in.
 *
 *   change_image IMAGE OTHER_IMAGE
 *
 * Prints a line for each step of the change, and the largest move of an output in a cycle: no axis jumps.
 */
#include "axisrt.h"
#include "image_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { cycle_time_ns = 1000000, most_axes = 64, cycles = 20000 };

static axisrt_status configure(const char* path, axisrt_config* config) {
  image_file image = {NULL, 0};
  size_t alignment = 0;
  axisrt_status status = AXISRT_BAD_ARGUMENT;
  if (!load_image_file(path, &image)) return status;
  config->size = sizeof *config;
  config->cycle_time_ns = cycle_time_ns;
  config->image = image.bytes;
  config->image_size = image.size;
  status = axisrt_memory_size(config, &config->memory_size, &alignment);
  if (status == AXISRT_OK) config->memory = aligned_memory(config->memory_size);
  return status;
}

int main(int argc, char* argv[]) {
  static double setpoint[most_axes], filtered[most_axes], before[most_axes];
  axisrt_config config = {0}, other = {0};
  axisrt *active = NULL, *prepared = NULL;
  axisrt_status status = AXISRT_OK, answer = AXISRT_OK;
  double largest = 0;
  int done = 0;
  if (argc != 3) return 2;
  status = configure(argv[1], &config);
  if (status == AXISRT_OK) status = configure(argv[2], &other);
  if (status == AXISRT_OK) status = axisrt_create(&config, &active);
  if (status == AXISRT_OK && axisrt_axis_count(active) > most_axes) status = AXISRT_BAD_ARGUMENT;
  for (uint32_t axis = 0; status == AXISRT_OK && axis < axisrt_axis_count(active); ++axis) {
    status = axisrt_reset(active, axis, 0);
  }
  /* Not in the cycle: this takes longer than a cycle lasts. */
  if (status == AXISRT_OK) status = axisrt_prepare(active, &other, 0, &prepared);
  for (int cycle = 0; status == AXISRT_OK && cycle < cycles && !done; ++cycle) {
    for (int axis = 0; axis < most_axes; ++axis) setpoint[axis] = 20.0 * cycle;
    status = axisrt_step(active, setpoint, filtered, NULL);
    for (uint32_t axis = 0; axis < axisrt_axis_count(active); ++axis) {
      largest = fmax(largest, fabs(filtered[axis] - before[axis]));
      before[axis] = filtered[axis];
    }
    if (active == prepared) {
      done = axisrt_swap_done(active); /* from here on the memory of the old runtime is free */
      if (done) printf("cycle %d: done\n", cycle);
      continue;
    }
    if (status == AXISRT_OK) status = axisrt_shadow_step(prepared);
    answer = axisrt_swap(prepared);
    if (answer != AXISRT_OK)
      continue; /* not warm yet, or only at standstill: asked again in the next cycle */
    active = prepared;
    printf("cycle %d: changing over\n", cycle);
  }
  if (!done) printf("not changed: %s, %s\n", axisrt_status_name(status), axisrt_status_name(answer));
  printf("largest move of an output in a cycle: %.3f\n", largest);
  return done ? 0 : 1;
}
