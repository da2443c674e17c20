// Two lanes: Advanced SIMD of AArch64.
#define AXISRT_LEVEL neon
#define AXISRT_LEVEL_NUMBER AXISRT_LEVEL_NEON
#define AXISRT_LANES 2
#define AXISRT_CONTRACTS  // multiplications and additions may become one instruction
#include "runtime/lanes/instructions_def.hpp"
