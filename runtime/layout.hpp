// Where the parts of a runtime stand in the caller's memory.
#pragma once

#include "runtime/image_view.hpp"

#include <stdint.h>

namespace axisc::runtime {

/// Number of elements of each part.
struct Amounts {
  uint64_t axes = 0;
  uint64_t filters = 0;
  uint64_t sections = 0;        ///< coefficient sets
  uint64_t section_states = 0;  ///< sections of all filters
  uint64_t ring_signals = 0;    ///< cycles of all delays
};

/// Offsets in bytes, each aligned to 64. What is fixed after create comes first, what a cycle changes behind
/// it.
struct Layout {
  uint64_t object = 0;
  uint64_t axes = 0;
  uint64_t setpoint_chains = 0;
  uint64_t interface_chains = 0;
  uint64_t filters = 0;
  uint64_t sections = 0;
  uint64_t setpoint_states = 0;
  uint64_t interface_states = 0;
  uint64_t section_states = 0;
  uint64_t ring_positions = 0;
  uint64_t ring_signals = 0;
  uint64_t size = 0;
};

/// Expects a verified image.
[[nodiscard]] Amounts count_amounts(ImageView const& view);
[[nodiscard]] Layout lay_out(Amounts const& amounts);

}  // namespace axisc::runtime
