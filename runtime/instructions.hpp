// The kernels in the instruction sets of a processor family, and which of them this processor has.
#pragma once

#include "axisrt.h"
#include "runtime/batch.hpp"

#include <stdint.h>

namespace axisc::runtime {

/// One instruction set. All functions are called with rounding to nearest and without traps.
struct Instructions {
  uint32_t level;  ///< an axisrt_level
  uint32_t lanes;  ///< of the widest group: 1, 2, 4 or 8
  /// One cycle of all lines; gives the worst status. `status` may be null.
  uint64_t (*step)(Port const& port, double const* in, double* out, uint8_t* status);
  /// One operation of one group, for self-tests. `signal` has base, sum and d of each lane, in and out.
  void (*run_operation)(Batch const& batch, uint32_t operation, uint32_t group, double* signal);
};

/// The level that a configuration asks for, the best one for AXISRT_LEVEL_AUTOMATIC. Null if this processor
/// or this build does not have it.
[[nodiscard]] Instructions const* find_instructions(uint32_t level);

/// Lanes of the widest group at a level, also of one that this processor does not have; 0 for an unknown
/// level.
[[nodiscard]] uint32_t lanes_of_level(uint32_t level);

}  // namespace axisc::runtime
