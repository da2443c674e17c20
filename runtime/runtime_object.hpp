// The object that the handle points to, in the caller's memory. Everything that is fixed after create is kept
// apart from what changes in a cycle.
#pragma once

#include "axisrt.h"
#include "runtime/batch.hpp"
#include "runtime/instructions.hpp"

#include <stdint.h>

namespace axisc::runtime {

struct Axis {
  uint32_t name_offset;
  uint32_t name_size;
  uint64_t name_digest;  ///< so that two runtimes can be compared when the images are gone
  uint32_t number;
  uint32_t type;
  double position_window;
  double velocity_limit;      ///< units per cycle
  double acceleration_limit;  ///< units per cycle and cycle
  double distance;  ///< proved bound of the sum of |s - 1| with any kernel; below 0 where the image has none
};

enum class FilterKind : uint32_t { pass_through, passing, shared, blocking, delay };

/// The place of a filter of the image in the operations of its batch.
struct Filter {
  FilterKind kind;
  uint32_t operation;
  uint32_t first_section;  ///< in the operation: those before it belong to other filters
  uint32_t section_count;
  uint32_t delay_cycles;
};

struct SlotSwitch {
  uint32_t on;  ///< 1: the filter is switched on
};

/// A linear-phase filter of an axis: its lane of a group.
struct Slot {
  SlotGroup* group;
  double* parts;  ///< the group's piece of the state (SlotParts)
  SlotSwitch* state;
  Kernel const* listed;  ///< of the lists' values
  uint32_t width;
  uint32_t lane;
  uint32_t history_length;
  uint32_t family;
  uint32_t on_at_start;
  uint32_t reserved;
};

/// The place of a line, and its chain.
struct LineChain {
  uint32_t batch;
  uint32_t group;
  uint32_t lane;
  uint32_t first_filter;  ///< in the image
  uint32_t filter_count;
  uint32_t reserved;
  Slot const* before;  ///< HSC; null where there is none
  Slot const* behind;  ///< FIR; null where there is none
};

struct LinePort {
  Port port;
  LineChain const* lines;
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

struct ChannelState {
  uint32_t bank;  ///< of the channel: the parameters that the commands so far have given the FIR filters
};

/// An NC channel.
struct Channel {
  Slot const* const* members;  ///< slots of its axes; null for an axis without one
  Bank const* banks;
  ChannelState* state;
  uint32_t member_count;
  uint32_t bank_count;
  uint32_t name_offset;
  uint32_t name_size;
  uint32_t off_fade_cycles;
  uint32_t reserved;
};

/// A stage of Improved Position Control: a line of the velocity port.
struct Stage {
  uint32_t mode;
  uint32_t axis;
  double weight;
};

/// Improved Position Control of an axis.
struct Control {
  uint32_t first_stage;
  uint32_t stage_count;
  uint32_t axis;
  uint32_t source;  ///< index of the control whose additive velocity it outputs: its own, or the master's
  double limit;
  double scale;
};

/// Stages in the latest cycle, in the order of the image.
struct StageSignals {
  double* in;
  double* out;
  uint8_t* status;
};

/// The change from the previous image to this one.
struct Change {
  axisrt* predecessor;     ///< the runtime before, until the change is done
  uint32_t begun;          ///< 1: this runtime is the one that is stepped
  uint32_t cycles;         ///< in which it ran along with its predecessor
  uint32_t standstill;     ///< cycles without a motion or a difference, lately
  uint32_t warm_up;        ///< cycles after which its outputs are as if it had always run
  uint32_t length;         ///< cycles of the fade; 0: at standstill only
  uint32_t position;       ///< cycles of it that are done
  uint32_t same_controls;  ///< 1: Improved Position Control is the same in both images
  uint32_t reserved;
  double* shadow;   ///< inputs or outputs of the predecessor; as many as axes or stages
  double* outputs;  ///< of all axes in the latest cycle of a change
};

}  // namespace axisc::runtime

struct axisrt {
  uint64_t memory_size;  ///< of everything, from this object on
  uint32_t axis_count;
  uint32_t cycle_time_ns;
  uint32_t kernel_count;
  uint32_t slot_count;
  uint32_t channel_count;
  uint32_t stage_count;
  uint32_t control_count;
  uint32_t image_version;
  uint32_t payload_checksum;  ///< of the image
  uint32_t header_checksum;   ///< of the image's header and section table
  axisc::runtime::Instructions const* instructions;
  uint8_t const* names;  ///< in the image; null if it has none
  axisc::runtime::Axis const* axes;
  axisc::runtime::Filter const* filters;
  axisc::runtime::LinePort setpoint;
  axisc::runtime::LinePort additional_interface;
  axisc::runtime::LinePort velocity;
  axisc::runtime::Kernel const* kernels;  ///< one more than the image has: the last lets the signal pass
  axisc::runtime::Slot const* slots;
  axisc::runtime::Channel const* channels;
  axisc::runtime::Stage const* stages;
  axisc::runtime::Control const* controls;
  axisc::runtime::StageSignals stage_signals;
  double* additive_velocities;  ///< of the controls, in the latest cycle
  axisc::runtime::Change* change;
  axisrt_recorder* recorder;  ///< null where nothing is recorded
};
