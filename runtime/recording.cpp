// Starts recorders, and writes their recordings.
#include "runtime/recording.hpp"

#include "axisrt.h"
#include "runtime/configuration.hpp"
#include "runtime/creation/building.hpp"
#include "runtime/format/crc32c.hpp"
#include "runtime/recorder.hpp"

namespace axisc::runtime {
namespace {

struct Counter {
  uint64_t words = 0;
  bool number(uint32_t from, uint32_t& to, uint32_t /*largest*/) {
    to = from;
    words += 1;
    return true;
  }
  bool states(Batch const& from, Batch const& /*to*/) {
    words += count_states(from);
    return true;
  }
};

}  // namespace

uint64_t count_state_words(axisrt const& runtime) {
  Counter counter;
  return walk(runtime, runtime, counter) ? counter.words : 0;
}

uint32_t content_checksum(uint8_t const* dump, uint64_t size) {
  return axim_crc32c(dump + header_size, static_cast<size_t>(size - header_size));
}

uint32_t header_checksum(uint8_t const* dump) {
  uint8_t const nothing[4] = {};
  uint32_t const before = axim_crc32c(dump, header_checksum_place);
  uint32_t const with_nothing = axim_crc32c(nothing, sizeof nothing, before);
  constexpr uint64_t behind = header_checksum_place + sizeof nothing;
  return axim_crc32c(dump + behind, header_size - behind, with_nothing);
}

namespace {

/// For commands and resets in addition to the cycles.
constexpr uint64_t spare_words = 256;

constexpr uint64_t aligned(uint64_t bytes) {
  return (bytes + AXISRT_ALIGNMENT - 1) / AXISRT_ALIGNMENT * AXISRT_ALIGNMENT;
}

struct RecorderLayout {
  uint64_t values, words, past, size;
  uint64_t capacity;
};

RecorderLayout lay_out_recorder(axisrt const& runtime, uint32_t cycles, uint64_t past_size) {
  EntrySizes const sizes = entry_sizes(runtime);
  uint64_t const largest = sizes.step_velocity > sizes.step ? sizes.step_velocity : sizes.step;
  uint64_t const cycle = sizes.step + sizes.step_interface + sizes.step_velocity;
  RecorderLayout layout{};
  layout.capacity = cycle * cycles + spare_words;
  layout.values = aligned(sizeof(axisrt_recorder));
  layout.words = layout.values + aligned(largest * word_size);
  layout.past = layout.words + aligned(layout.capacity * word_size);
  layout.size = layout.past + aligned(past_size);
  return layout;
}

/// The configuration of the runtime that follows the ring.
axisrt_config config_of_past(axisrt const& runtime, axisrt_config const& config) {
  axisrt_config past = config;
  past.level = axisrt_level_of(&runtime);
  past.cycle_time_ns = runtime.cycle_time_ns;
  return past;
}

struct Copier {
  static bool number(uint32_t from, uint32_t& to, uint32_t largest) {
    to = from;
    return from <= largest;
  }
  static bool states(Batch const& from, Batch const& to) {
    for (uint64_t i = 0; i < count_states(from); ++i) to.states[i] = from.states[i];
    return true;
  }
};

void store_word(uint8_t*& to, uint64_t word) {
  for (uint32_t i = 0; i < word_size; ++i) to[i] = static_cast<uint8_t>(word >> 8 * i);
  to += word_size;
}

struct Writer {
  uint8_t* to;
  bool number(uint32_t from, uint32_t& same, uint32_t /*largest*/) {
    same = from;
    store_word(to, from);
    return true;
  }
  bool states(Batch const& from, Batch const& /*to*/) {
    for (uint64_t i = 0; i < count_states(from); ++i) store_word(to, std::bit_cast<uint64_t>(from.states[i]));
    return true;
  }
};

void write_dump(axisrt_recorder const& recorder, uint64_t state_words, uint8_t* bytes, uint64_t size) {
  axisrt const& past = *recorder.past;
  uint8_t* to = bytes;
  store_word(to, uint64_t{'A'} | uint64_t{'X'} << 8U | uint64_t{'R'} << 16U | uint64_t{'D'} << 24U |
                     uint64_t{axrd_major} << 32U | uint64_t{axrd_minor} << 48U);
  store_word(to, axisrt_level_of(&past) | uint64_t{past.axis_count} << 32U);
  store_word(to, past.cycle_time_ns | uint64_t{past.payload_checksum} << 32U);
  store_word(to, state_words);
  store_word(to, recorder.used);
  store_word(to, recorder.entries);
  to += word_size;
  store_word(to, 0);
  Writer writer{.to = to};
  static_cast<void>(walk(past, past, writer));
  to = writer.to;
  for (uint64_t i = 0; i < recorder.used; ++i) {
    uint64_t const at = recorder.first + i;
    store_word(to, recorder.words[at >= recorder.capacity ? at - recorder.capacity : at]);
  }
  uint32_t const content = content_checksum(bytes, size);
  to = bytes + content_checksum_place;
  store_word(to, content);
  uint32_t const header = header_checksum(bytes);
  to = bytes + content_checksum_place;
  store_word(to, content | uint64_t{header} << 32U);
}

/// Checksums guard against mistakes; the counts, with those that a walk compares, against images that were
/// made to have the same ones.
bool same_image(axisrt const& a, axisrt const& b) {
  return a.payload_checksum == b.payload_checksum && a.header_checksum == b.header_checksum &&
         a.axis_count == b.axis_count && a.control_count == b.control_count &&
         a.channel_count == b.channel_count;
}

axisrt_status start(axisrt& runtime, axisrt_config const& config, uint32_t cycles,
                    axisrt_recorder*& recorder) {
  axisrt_config past = config_of_past(runtime, config);
  size_t past_size = 0;
  size_t alignment = 0;
  axisrt_status status = axisrt_memory_size(&past, &past_size, &alignment);
  if (status != AXISRT_OK) return status;
  RecorderLayout const layout = lay_out_recorder(runtime, cycles, past_size);
  status = check_memory(config, layout.size);
  if (status != AXISRT_OK) return status;
  Block const own{.first = config.memory, .size = layout.size};
  if (overlap(own, {.first = &runtime, .size = runtime.memory_size})) return AXISRT_BAD_ARGUMENT;
  Memory const memory{.bytes = static_cast<uint8_t*>(config.memory)};
  past.memory = memory.part<uint8_t>(layout.past);
  past.memory_size = past_size;
  axisrt* behind = nullptr;
  status = axisrt_create(&past, &behind);
  if (status != AXISRT_OK) return status;
  Copier copier;
  if (!same_image(runtime, *behind) || !walk(runtime, *behind, copier)) return AXISRT_OTHER_IMAGE;
  recorder = memory.part<axisrt_recorder>(0);
  *recorder = {.runtime = &runtime,
               .past = behind,
               .words = memory.part<uint64_t>(layout.words),
               .values = memory.part<double>(layout.values),
               .memory_size = layout.size,
               .capacity = layout.capacity,
               .first = 0,
               .used = 0,
               .entries = 0,
               .sizes = entry_sizes(runtime)};
  runtime.recorder = recorder;
  return AXISRT_OK;
}

}  // namespace
}  // namespace axisc::runtime

axisrt_status axisrt_recorder_size(axisrt const* runtime, axisrt_config const* config, uint32_t cycles,
                                   size_t* bytes) {
  using namespace axisc::runtime;
  if (runtime == nullptr || !is_known(config) || bytes == nullptr) return AXISRT_BAD_ARGUMENT;
  axisrt_config const past = config_of_past(*runtime, *config);
  size_t past_size = 0;
  size_t alignment = 0;
  axisrt_status const status = axisrt_memory_size(&past, &past_size, &alignment);
  if (status != AXISRT_OK) return status;
  uint64_t const size = lay_out_recorder(*runtime, cycles, past_size).size;
  if (size > SIZE_MAX) return AXISRT_MEMORY_TOO_SMALL;
  *bytes = static_cast<size_t>(size);
  return AXISRT_OK;
}

axisrt_status axisrt_recorder_start(axisrt* runtime, axisrt_config const* config, uint32_t cycles,
                                    axisrt_recorder** recorder) {
  using namespace axisc::runtime;
  if (recorder == nullptr) return AXISRT_BAD_ARGUMENT;
  *recorder = nullptr;
  if (runtime == nullptr || !is_known(config)) return AXISRT_BAD_ARGUMENT;
  if (runtime->recorder != nullptr || runtime->change->predecessor != nullptr) return AXISRT_BUSY;
  return start(*runtime, *config, cycles, *recorder);
}

void axisrt_recorder_stop(axisrt_recorder* recorder) {
  if (recorder == nullptr || recorder->runtime == nullptr) return;
  recorder->runtime->recorder = nullptr;
  recorder->runtime = nullptr;
}

axisrt_status axisrt_recorder_dump(axisrt_recorder const* recorder, void* bytes, size_t size,
                                   size_t* needed) {
  using namespace axisc::runtime;
  if (recorder == nullptr || needed == nullptr) return AXISRT_BAD_ARGUMENT;
  uint64_t const state_words = count_state_words(*recorder->past);
  uint64_t const all = (axrd_header_words + state_words + recorder->used) * word_size;
  if (all > SIZE_MAX) return AXISRT_MEMORY_TOO_SMALL;
  *needed = static_cast<size_t>(all);
  if (size < all || bytes == nullptr) return AXISRT_MEMORY_TOO_SMALL;
  write_dump(*recorder, state_words, static_cast<uint8_t*>(bytes), all);
  return AXISRT_OK;
}
