// One lane and separately rounded operations: the same result on every processor.
#define AXISRT_LEVEL portable
#define AXISRT_LEVEL_NUMBER AXISRT_LEVEL_PORTABLE
#define AXISRT_LANES 1
#include "runtime/lanes/instructions_def.hpp"
