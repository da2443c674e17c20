/* The runtime in C11: a step of 1000 units on every axis of an image, one line per NC cycle.
 *
 *   filter_in_c IMAGE [CYCLES]
 */
#include "axisrt.h"
#include "image_file.h"

#include <stdio.h>
#include <stdlib.h>

enum { cycle_time_ns = 1000000, most_axes = 64 };

static axisrt* create(const image_file* image, void** memory) {
  axisrt_config config = {0};
  axisrt* runtime = NULL;
  size_t alignment = 0;
  axisrt_status status = AXISRT_OK;
  config.size = sizeof config;
  config.cycle_time_ns = cycle_time_ns;
  config.image = image->bytes;
  config.image_size = image->size;
  status = axisrt_memory_size(&config, &config.memory_size, &alignment);
  if (status == AXISRT_OK) {
    *memory = aligned_memory(config.memory_size);
    config.memory = *memory;
    status = axisrt_create(&config, &runtime);
  }
  if (status != AXISRT_OK)
    fprintf(stderr, "%s: %s\n", axisrt_status_name(status), axisrt_status_text(status));
  return runtime;
}

static int execute(axisrt* runtime, int cycles) {
  double in[most_axes] = {0};
  double out[most_axes] = {0};
  uint8_t status[most_axes] = {0};
  const uint32_t axes = axisrt_axis_count(runtime);
  uint32_t axis = 0;
  int cycle = 0;
  if (axes > most_axes) return 0;
  for (axis = 0; axis < axes; ++axis) {
    if (axisrt_reset(runtime, axis, 0.0) != AXISRT_OK) return 0; /* where the axis is */
    in[axis] = 1000.0;
  }
  for (cycle = 0; cycle < cycles; ++cycle) {
    if (axisrt_step(runtime, in, out, status) != AXISRT_OK) return 0;
    printf("%d", cycle);
    for (axis = 0; axis < axes; ++axis) printf(" %.17g", out[axis]);
    printf("\n");
  }
  return 1;
}

int main(int argc, char* argv[]) {
  image_file image = {NULL, 0};
  void* memory = NULL;
  axisrt* runtime = NULL;
  int good = 0;
  if (argc < 2) {
    fprintf(stderr, "usage: filter_in_c IMAGE [CYCLES]\n");
    return 2;
  }
  if (load_image_file(argv[1], &image)) runtime = create(&image, &memory);
  if (runtime != NULL) good = execute(runtime, argc > 2 ? atoi(argv[2]) : 20);
  free(memory);
  free(image.bytes);
  return good ? 0 : 1;
}
