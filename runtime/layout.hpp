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
  uint64_t kernels = 0;         ///< one more than the image has: the last lets the signal pass
  uint64_t tails = 0;
  uint64_t slots = 0;
  uint64_t history = 0;  ///< increments of all slots, each twice
  uint64_t groups = 0;
  uint64_t members = 0;
  uint64_t banks = 0;
  uint64_t choices = 0;
  uint64_t controls = 0;
  uint64_t stages = 0;
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
  uint64_t kernels = 0;
  uint64_t tails = 0;
  uint64_t slots = 0;
  uint64_t groups = 0;
  uint64_t members = 0;
  uint64_t banks = 0;
  uint64_t choices = 0;
  uint64_t controls = 0;
  uint64_t stages = 0;
  uint64_t setpoint_states = 0;
  uint64_t interface_states = 0;
  uint64_t section_states = 0;
  uint64_t ring_positions = 0;
  uint64_t ring_signals = 0;
  uint64_t slot_states = 0;
  uint64_t history = 0;
  uint64_t stage_states = 0;
  uint64_t additive_velocities = 0;
  uint64_t size = 0;
};

/// Increments that a slot remembers; at least 1.
[[nodiscard]] uint64_t history_length(Record<record::slot> slot);
/// Expects a verified image.
[[nodiscard]] Amounts count_amounts(ImageView const& view);
[[nodiscard]] Layout lay_out(Amounts const& amounts);

}  // namespace axisc::runtime
