/* A motion that drives every port of a runtime, the same on every processor: what comes out at level portable
 * is equal bit for bit. */
#ifndef AXISC_TESTS_BARE_METAL_MOTION_H
#define AXISC_TESTS_BARE_METAL_MOTION_H

#include "axisrt.h"

#include <stddef.h>
#include <stdint.h>

enum { motion_cycles = 200, motion_most_axes = 8 };

/* What an output is given to: the bits of a double, or a status. */
typedef void (*motion_output)(void* context, uint64_t bits);

/* Resets all axes of a runtime that was just created, executes motion_cycles cycles with commands in between
 * and hands every output over. Returns 0, or the number of the first axis too many. */
int motion_execute(axisrt* runtime, motion_output output, void* context);

#endif
