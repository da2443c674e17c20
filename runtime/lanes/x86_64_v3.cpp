// Four lanes: AVX2 and FMA.
#define AXISRT_LEVEL x86_64_v3
#define AXISRT_LEVEL_NUMBER AXISRT_LEVEL_X86_64_V3
#define AXISRT_LANES 4
#define AXISRT_CONTRACTS  // multiplications and additions may become one instruction
#include "runtime/lanes/instructions_def.hpp"
