// Checks that all calls with a configuration share.
#pragma once

#include "axisrt.h"

#include <stdint.h>

namespace axisc::runtime {

/// A piece of memory.
struct Block {
  void const* first = nullptr;
  uint64_t size = 0;
};

[[nodiscard]] inline bool overlap(Block const& a, Block const& b) {
  auto const first_of_a = reinterpret_cast<uintptr_t>(a.first);
  auto const first_of_b = reinterpret_cast<uintptr_t>(b.first);
  return first_of_a < first_of_b ? first_of_b - first_of_a < a.size : first_of_a - first_of_b < b.size;
}

[[nodiscard]] inline Block image_of(axisrt_config const& config) {
  return {.first = config.image, .size = config.image_size};
}

[[nodiscard]] inline bool is_known(axisrt_config const* config) {
  return config != nullptr && config->size == sizeof(axisrt_config) && config->reserved == 0;
}

/// Whether `needed` bytes of the configuration's memory can be written to without touching its image.
[[nodiscard]] inline axisrt_status check_memory(axisrt_config const& config, uint64_t needed) {
  if (config.memory == nullptr) return AXISRT_BAD_ARGUMENT;
  if (reinterpret_cast<uintptr_t>(config.memory) % AXISRT_ALIGNMENT != 0) return AXISRT_MISALIGNED;
  if (config.memory_size < needed) return AXISRT_MEMORY_TOO_SMALL;
  Block const memory{.first = config.memory, .size = needed};
  return overlap(memory, image_of(config)) ? AXISRT_BAD_ARGUMENT : AXISRT_OK;
}

/// axisrt_create of a known configuration, whose memory must touch neither of two pieces that are in use.
axisrt_status create_beside(axisrt_config const& config, Block const& used, Block const& used_too,
                            axisrt*& runtime);

}  // namespace axisc::runtime
