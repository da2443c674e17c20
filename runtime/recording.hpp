// Parts that writing and reading a recording share (format/recording_format.h).
#pragma once

#include "runtime/format/recording_format.h"
#include "runtime/state_words.hpp"

#include <stdint.h>

namespace axisc::runtime {

inline constexpr uint64_t word_size = 8;
inline constexpr uint64_t header_size = axrd_header_words * word_size;
inline constexpr uint64_t content_checksum_place = 6 * word_size;
inline constexpr uint64_t header_checksum_place = content_checksum_place + 4;

/// Checksum of everything after the header.
[[nodiscard]] uint32_t content_checksum(uint8_t const* dump, uint64_t size);
/// Checksum of the header, with its own place as zero.
[[nodiscard]] uint32_t header_checksum(uint8_t const* dump);

/// Words of the state in a recording.
[[nodiscard]] uint64_t count_state_words(axisrt const& runtime);

/// Doubles of all groups of a batch.
[[nodiscard]] inline uint64_t count_states(Batch const& batch) {
  return uint64_t{batch.group_count} * batch.state_stride;
}

template <class Visitor>
bool walk(axisrt const& from, axisrt const& to, Visitor& visitor) {
  return StateWalk<Visitor>(from, to, visitor).walk();
}

}  // namespace axisc::runtime
