// Where the parts of a runtime are in the caller's memory.
#pragma once

#include "runtime/verification/image_view.hpp"

#include <stdint.h>

namespace axisc::runtime {

/// Numbers of elements that the lines of a port need.
struct PortAmounts {
  uint64_t lines = 0;
  uint64_t batches = 0;
  uint64_t lanes = 0;       ///< of all groups
  uint64_t operations = 0;  ///< of all batches
  uint64_t pieces = 0;      ///< of constants: operations of all groups
  uint64_t constants = 0;   ///< doubles
  uint64_t states = 0;      ///< doubles
  uint64_t slot_groups = 0;
  uint64_t lane_tails = 0;  ///< doubles
};

struct Amounts {
  PortAmounts setpoint, additional_interface, velocity;
  uint64_t axes = 0;
  uint64_t filters = 0;
  uint64_t kernels = 0;  ///< one more than the image has: the last lets the signal pass
  uint64_t tails = 0;    ///< doubles, with the zeros around them
  uint64_t slots = 0;
  uint64_t channels = 0;
  uint64_t members = 0;
  uint64_t banks = 0;
  uint64_t choices = 0;
  uint64_t controls = 0;
  uint64_t stages = 0;
};

/// Offsets in bytes, each aligned to 64.
struct PortLayout {
  uint64_t batches = 0;
  uint64_t lines = 0;
  uint64_t lanes = 0;
  uint64_t batch_states = 0;
  uint64_t pieces = 0;
  uint64_t constants = 0;
  uint64_t operation_states = 0;
  uint64_t slot_groups = 0;
  uint64_t lane_tails = 0;
  uint64_t states = 0;
};

struct Layout {
  uint64_t object = 0;
  PortLayout setpoint, additional_interface, velocity;
  uint64_t axes = 0;
  uint64_t filters = 0;
  uint64_t kernels = 0;
  uint64_t tails = 0;
  uint64_t slots = 0;
  uint64_t slot_switches = 0;
  uint64_t channels = 0;
  uint64_t channel_states = 0;
  uint64_t members = 0;
  uint64_t banks = 0;
  uint64_t choices = 0;
  uint64_t controls = 0;
  uint64_t stages = 0;
  uint64_t stage_in = 0;
  uint64_t stage_out = 0;
  uint64_t stage_status = 0;
  uint64_t additive_velocities = 0;
  uint64_t change = 0;
  uint64_t shadow = 0;
  uint64_t changing_outputs = 0;
  uint64_t size = 0;
};

/// Doubles of a kernel's tails: seven zeros in front, and so many after them that whole blocks can be
/// applied.
[[nodiscard]] uint32_t padded_tails(uint32_t block_count);

/// Expects a verified image. `lanes` are those of the instruction set that will execute it.
[[nodiscard]] Amounts count_amounts(ImageView const& view, uint32_t lanes);
[[nodiscard]] Layout lay_out(Amounts const& amounts);

}  // namespace axisc::runtime
