// Eight lanes: AVX-512 F, BW, CD, DQ and VL.
#define AXISRT_LEVEL x86_64_v4
#define AXISRT_LEVEL_NUMBER AXISRT_LEVEL_X86_64_V4
#define AXISRT_LANES 8
#define AXISRT_CONTRACTS  // multiplications and additions may become one instruction
#include "runtime/lanes/instructions_def.hpp"
