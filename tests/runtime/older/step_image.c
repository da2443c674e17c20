/* Steps an image by a fixed signal and prints a hash of all outputs' bits: step_image IMAGE. Uses nothing
   that the first runtime of image format 1.1 did not have. */
#include <axisrt.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { cycles = 200000, cycle_time_offset = 32 };

static void* read_image(char const* path, size_t* size) {
  FILE* const file = fopen(path, "rb");
  if (file == NULL || fseek(file, 0, SEEK_END) != 0) return NULL;
  *size = (size_t)ftell(file);
  rewind(file);
  void* const image = aligned_alloc(64, (*size + 63) / 64 * 64);
  size_t const got = image == NULL ? 0 : fread(image, 1, *size, file);
  fclose(file);
  return got == *size ? image : NULL;
}

static int refused(char const* what, axisrt_status status) {
  printf("%s: status %d\n", what, (int)status);
  return 1;
}

int main(int count, char** words) {
  size_t size = 0;
  void* const image = count == 2 ? read_image(words[1], &size) : NULL;
  if (image == NULL) return refused("image", AXISRT_BAD_ARGUMENT);
  uint32_t cycle_time_ns;
  memcpy(&cycle_time_ns, (char*)image + cycle_time_offset, sizeof cycle_time_ns);
  axisrt_config config = {0};
  config.size = sizeof config;
  config.cycle_time_ns = cycle_time_ns;
  config.image = image;
  config.image_size = size;
  config.level = AXISRT_LEVEL_PORTABLE;
  size_t alignment = 0;
  axisrt_status status = axisrt_memory_size(&config, &config.memory_size, &alignment);
  if (status != AXISRT_OK) return refused("memory_size", status);
  config.memory = aligned_alloc(4096, (config.memory_size + 4095) / 4096 * 4096);
  axisrt* runtime = NULL;
  status = axisrt_create(&config, &runtime);
  if (status != AXISRT_OK) return refused("create", status);
  uint32_t const axes = axisrt_axis_count(runtime);
  double* const in = calloc(axes, sizeof *in);
  double* const out = calloc(axes, sizeof *out);
  uint8_t* const axis_status = calloc(axes, sizeof *axis_status);
  for (uint32_t axis = 0; axis < axes; ++axis) axisrt_reset(runtime, axis, 0);
  uint64_t hash = 1469598103934665603U; /* FNV-1a, by words */
  for (int n = 0; n < cycles; ++n) {
    for (uint32_t axis = 0; axis < axes; ++axis) {
      in[axis] = 100 * sin(0.001 * n * (axis + 1)) + n / 1000 % 2 * 5;
    }
    axisrt_step(runtime, in, out, axis_status);
    for (uint32_t axis = 0; axis < axes; ++axis) {
      uint64_t bits;
      memcpy(&bits, &out[axis], sizeof bits);
      hash = (hash ^ bits) * 1099511628211U;
    }
  }
  printf("%016llx\n", (unsigned long long)hash);
  return 0;
}
