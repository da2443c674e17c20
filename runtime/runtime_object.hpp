// What stands in the caller's memory behind the handle. Everything that is fixed after create stands apart
// from what changes in a cycle, and equal things of all axes stand together.
#pragma once

#include "axisrt.h"
#include "runtime/double_bits.hpp"
#include "runtime/filter_kernel.hpp"

#include <stdint.h>

namespace axisc::runtime {

struct Axis {
  uint32_t name_offset;
  uint32_t name_size;
  double position_window;
};

/// Filters in series.
struct Chain {
  Filter const* filters;
  uint32_t filter_count;
  uint32_t reserved;
};

struct ChainState {
  double input;   ///< the last good setpoint
  double output;  ///< 0 before the first reset
  double filter_output[AXISRT_MOST_FILTERS];
  Mask reset_done;  ///< all bits set after a reset
};

/// Chains of all axes that one call executes.
struct Port {
  Chain const* chains;
  ChainState* states;
};

}  // namespace axisc::runtime

struct axisrt {
  uint32_t axis_count;
  uint32_t filter_count;
  uint32_t cycle_time_ns;
  uint32_t reserved;
  uint8_t const* names;  ///< in the image; null if it has none
  axisc::runtime::Axis const* axes;
  axisc::runtime::Filter const* filters;
  axisc::runtime::Port setpoint;
  axisc::runtime::Port additional_interface;
};
