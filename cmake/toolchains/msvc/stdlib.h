/* The functions that an FMU needs from this header of the C library. */
#pragma once

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif
void* calloc(size_t count, size_t size);
void free(void* memory);
#ifdef __cplusplus
}
#endif
