/* The functions that the runtime and FMUs need from this header of the C library. */
#pragma once

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif
void* memcpy(void* to, void const* from, size_t size);
void* memset(void* to, int value, size_t size);
void* memmove(void* to, void const* from, size_t size);
int memcmp(void const* a, void const* b, size_t size);
int strcmp(char const* a, char const* b);
size_t strlen(char const* text);
#ifdef __cplusplus
}
#endif
