/* The functions that the runtime needs from this header of the C library. */
#pragma once

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif
void* memcpy(void* to, void const* from, size_t size);
void* memset(void* to, int value, size_t size);
void* memmove(void* to, void const* from, size_t size);
int memcmp(void const* a, void const* b, size_t size);
#ifdef __cplusplus
}
#endif
