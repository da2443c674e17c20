// Two lanes: SSE up to 4.2.
#define AXISRT_LEVEL x86_64_v2
#define AXISRT_LEVEL_NUMBER AXISRT_LEVEL_X86_64_V2
#define AXISRT_LANES 2
#include "runtime/lanes/instructions_def.hpp"
