// Names that differ between compilers. Compilers other than GCC and clang build the portable level only.
#pragma once

#if defined(__GNUC__)
#define AXISRT_INLINE inline __attribute__((always_inline))
#define AXISRT_INLINE_LAMBDA __attribute__((always_inline))
#define AXISRT_APART __attribute__((noinline))
#define AXISRT_BIT_CAST(type, value) __builtin_bit_cast(type, value)
#define AXISRT_CONVERT(value, type) __builtin_convertvector(value, type)
#define AXISRT_LANES_OF(vector, ...) __builtin_shufflevector(vector, vector, __VA_ARGS__)
#define AXISRT_COPY(to, from, size) __builtin_memcpy(to, from, size)
#else
#include <bit>
#include <string.h>
#define AXISRT_INLINE inline
#define AXISRT_INLINE_LAMBDA
#define AXISRT_APART __declspec(noinline)
#define AXISRT_BIT_CAST(type, value) std::bit_cast<type>(value)
#define AXISRT_CONVERT(value, type) static_cast<type>(value)
#define AXISRT_LANES_OF(vector, ...) (vector)
#define AXISRT_COPY(to, from, size) memcpy(to, from, size)
#endif
