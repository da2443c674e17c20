// What stands in the caller's memory behind the handle. Everything that is fixed after create stands apart
// from what changes in a cycle, and equal things of all axes stand together.
#pragma once

#include "axisrt.h"
#include "runtime/chain.hpp"
#include "runtime/double_bits.hpp"

#include <stdint.h>

namespace axisc::runtime {

struct Axis {
  uint32_t name_offset;
  uint32_t name_size;
  double position_window;
};

/// Chains of all axes that one call executes.
struct Port {
  Chain const* chains;
  ChainState* states;
};

/// A set of #FILTER parameters: one kernel for each member of its group.
struct Bank {
  uint32_t keywords;
  uint32_t order;
  double share, frequency, quality;
  Kernel const* const* choices;
  uint32_t fade_cycles;
  uint32_t reserved;
};

/// An NC channel.
struct Group {
  Slot const* const* members;  ///< slots of its axes; null for an axis without one
  Bank const* banks;
  uint32_t member_count;
  uint32_t bank_count;
  uint32_t name_offset;
  uint32_t name_size;
  uint32_t off_fade_cycles;
  uint32_t reserved;
};

/// A stage of Improved Position Control.
struct Stage {
  Chain chain;
  uint32_t mode;
  uint32_t reserved;
  double weight;
};

/// Improved Position Control of an axis.
struct Control {
  Stage const* stages;
  ChainState* stage_states;
  uint32_t stage_count;
  uint32_t axis;
  uint32_t source;  ///< index of the control whose additive velocity it gives out: its own, or the master's
  uint32_t reserved;
  double limit;
  double scale;
};

}  // namespace axisc::runtime

struct axisrt {
  uint32_t axis_count;
  uint32_t filter_count;
  uint32_t cycle_time_ns;
  uint32_t kernel_count;
  uint32_t slot_count;
  uint32_t group_count;
  uint32_t control_count;
  uint32_t reserved;
  uint8_t const* names;  ///< in the image; null if it has none
  axisc::runtime::Axis const* axes;
  axisc::runtime::Filter const* filters;
  axisc::runtime::Port setpoint;
  axisc::runtime::Port additional_interface;
  axisc::runtime::Kernel const* kernels;  ///< one more than the image has: the last lets the signal pass
  axisc::runtime::Slot const* slots;
  axisc::runtime::Group const* groups;
  axisc::runtime::Control const* controls;
  double* additive_velocities;  ///< of the controls, in the latest cycle
};
