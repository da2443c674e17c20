// Included before every source: first the headers that may use what only Clang has, then pragmas against it.
#pragma once

#include <bit>
#include <limits>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <xmmintrin.h>

#undef __x86_64__
#undef __SSE2__

#pragma GCC poison __attribute__ \
    __attribute __asm__ __asm asm __typeof__ __extension__ __int128 __uint128_t vector_size
#pragma GCC poison __builtin_bit_cast __builtin_memcpy \
    __builtin_memset __builtin_convertvector __builtin_shufflevector __builtin_expect
#pragma GCC poison __builtin_ia32_ldmxcsr __builtin_ia32_stmxcsr __builtin_ia32_crc32di __builtin_clz \
    __builtin_ctz __builtin_huge_val
#pragma GCC poison __builtin_fma __builtin_unreachable __builtin_trap \
    __get_cpuid __restrict__ __inline__ always_inline
