#include "axisrt.h"

uint32_t axisrt_abi_version(void) { return AXISRT_ABI_VERSION; }
