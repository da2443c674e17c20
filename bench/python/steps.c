/* Processor time of cycles in C, for bench/python/measure.py:  steps IMAGE CYCLES REPETITIONS */
#include "axisrt.h"
#include "image_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { cycle_time_ns = 1000000 };

int main(int argc, char* argv[]) {
  image_file image = {NULL, 0};
  axisrt_config config = {0};
  axisrt* runtime = NULL;
  size_t alignment = 0;
  if (argc != 4 || !load_image_file(argv[1], &image)) return 2;
  config.size = sizeof config;
  config.cycle_time_ns = cycle_time_ns;
  config.image = image.bytes;
  config.image_size = image.size;
  if (axisrt_memory_size(&config, &config.memory_size, &alignment) != AXISRT_OK) return 2;
  config.memory = aligned_memory(config.memory_size);
  if (axisrt_create(&config, &runtime) != AXISRT_OK) return 2;
  const uint32_t axes = axisrt_axis_count(runtime);
  const size_t cycles = (size_t)atol(argv[2]);
  double* in = malloc(cycles * axes * sizeof(double));
  double* out = malloc(cycles * axes * sizeof(double));
  if (in == NULL || out == NULL) return 2;
  for (size_t i = 0; i < cycles * axes; ++i) in[i] = (double)(i % 1009);
  for (int repetition = atoi(argv[3]); repetition > 0; --repetition) {
    for (uint32_t axis = 0; axis < axes; ++axis) {
      if (axisrt_reset(runtime, axis, 0.0) != AXISRT_OK) return 2;
    }
    const clock_t begin = clock();
    for (size_t i = 0; i < cycles * axes; i += axes) {
      if (axisrt_step(runtime, in + i, out + i, NULL) != AXISRT_OK) return 2;
    }
    printf("%.9f\n", (double)(clock() - begin) / CLOCKS_PER_SEC);
  }
  return 0;
}
