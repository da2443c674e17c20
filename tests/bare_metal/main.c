/* The runtime on a microcontroller: images in flash, static memory, outputs compared with the host's bit for
 * bit. The result is printed through the debugger's semihosting. */
#include "tests/bare_metal/motion.h"
#include "tests/bare_metal/motion_c99.h"

#include <stdio.h>
#include <stdlib.h>

extern uint8_t const image_complete[];
extern uint8_t const image_complete_end[];
extern uint8_t const image_stripped[];
extern uint8_t const image_stripped_end[];

static uint64_t const expected[] = {
#include "expected_outputs.inc"
};
enum { expected_count = sizeof expected / sizeof expected[0] };

static _Alignas(AXISRT_ALIGNMENT) uint8_t memory[64 * 1024];

typedef struct comparison {
  size_t compared;
  size_t different;
} comparison;

static void compare(void* context, uint64_t bits) {
  comparison* const so_far = context;
  if (so_far->compared >= expected_count || expected[so_far->compared] != bits) ++so_far->different;
  ++so_far->compared;
}

/* 1 if everything is as it shall be. */
static int execute(char const* name, uint8_t const* image, uint8_t const* image_end) {
  comparison result = {0, 0};
  axisrt* runtime = NULL;
  size_t size = 0;
  size_t alignment = 0;
  axisrt_config config = {0};
  axisrt_status status = AXISRT_OK;
  config.size = sizeof config;
  config.cycle_time_ns = 1000000;
  config.image = image;
  config.image_size = (size_t)(image_end - image);
  config.memory = memory;
  config.memory_size = sizeof memory;
  status = axisrt_memory_size(&config, &size, &alignment);
  if (status == AXISRT_OK) status = axisrt_create(&config, &runtime); /* runs the self-tests */
  if (status != AXISRT_OK) {
    printf("%s: %s\n", name, axisrt_status_name(status));
    return 0;
  }
  if (motion_execute(runtime, compare, &result) != 0 || axisrt_level_of(runtime) != AXISRT_LEVEL_PORTABLE)
    return 0;
  printf("%s: %lu bytes of flash, %lu bytes of memory, %lu outputs, %lu different\n", name,
         (unsigned long)config.image_size, (unsigned long)size, (unsigned long)result.compared,
         (unsigned long)result.different);
  return result.different == 0 && result.compared == expected_count;
}

/* The runtime in C99 with the same image: the same outputs. */
static int execute_c99(uint8_t const* image, uint8_t const* image_end) {
  comparison result = {0, 0};
  axisrt_c* runtime = NULL;
  size_t size = 0;
  size_t const image_size = (size_t)(image_end - image);
  axisrt_c_status status = axisrt_c_memory_size(image, image_size, &size);
  if (status == AXISRT_C_OK) status = axisrt_c_create(image, image_size, memory, sizeof memory, &runtime);
  if (status != AXISRT_C_OK || motion_execute_c99(runtime, compare, &result) != 0) {
    printf("axisrt_c: status %d\n", (int)status);
    return 0;
  }
  printf("axisrt_c: %lu bytes of memory, %lu outputs, %lu different\n", (unsigned long)size,
         (unsigned long)result.compared, (unsigned long)result.different);
  return result.different == 0 && result.compared == expected_count;
}

/* A damaged image is refused here as anywhere: the checksum of the last byte. */
static int refuses_damage(void) {
  static _Alignas(AXISRT_ALIGNMENT) uint8_t copy[16 * 1024];
  size_t const size = (size_t)(image_stripped_end - image_stripped);
  size_t i = 0;
  if (size > sizeof copy) return 0;
  for (i = 0; i < size; ++i) copy[i] = image_stripped[i];
  copy[size - 1] ^= 1;
  return axisrt_verify(copy, size) == AXISRT_WRONG_CHECKSUM;
}

int main(void) {
  int good = execute("complete image", image_complete, image_complete_end);
  good &= execute("stripped image", image_stripped, image_stripped_end);
  good &= execute_c99(image_complete, image_complete_end);
  good &= refuses_damage();
  printf(good ? "passed\n" : "FAILED\n");
  if (!good) abort(); /* semihosting's plain exit has no status */
  return 0;
}
