/* motion_execute() for axisrt_c: the same calls in the same order, so the same outputs. */
#ifndef AXISC_TESTS_BARE_METAL_MOTION_C99_H
#define AXISC_TESTS_BARE_METAL_MOTION_C99_H

#include "axisrt_c.h"
#include "tests/bare_metal/motion.h"

int motion_execute_c99(axisrt_c* runtime, motion_output output, void* context);

#endif
