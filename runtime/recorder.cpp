#include "runtime/recorder.hpp"

#include "runtime/compiler.hpp"
#include "runtime/double_bits.hpp"

#include <stddef.h>

namespace axisc::runtime {
namespace {

constexpr uint32_t statuses_in_word = 8;

uint64_t status_words(uint32_t axes) {
  return (axes + statuses_in_word - 1) / statuses_in_word;
}

/// Words of an entry with its head.
uint64_t size_of(axisrt const& runtime, uint32_t kind) {
  uint64_t const axes = runtime.axis_count;
  switch (kind) {
    case axrd_step:
    case axrd_step_interface: return 1 + 2 * axes + status_words(runtime.axis_count);
    case axrd_step_velocity: return 1 + 5 * axes + status_words(runtime.axis_count);
    case axrd_reset_velocity: return 1 + 3;
    case axrd_command: return 1 + axrd_command_words;
    default: return 1 + 1;
  }
}

uint64_t place(axisrt_recorder const& recorder, uint64_t behind_first) {
  uint64_t const at = recorder.first + behind_first;
  return at >= recorder.capacity ? at - recorder.capacity : at;
}

/// How many of `count` words are between `place` and the end of the ring.
uint64_t before_end(axisrt_recorder const& recorder, uint64_t place, uint64_t count) {
  uint64_t const left = recorder.capacity - place;
  return count < left ? count : left;
}

/// Numbers and words are the same bytes.
void copy_words(void* to, void const* from, uint64_t count) {
  AXISRT_COPY(to, from, static_cast<size_t>(count * sizeof(uint64_t)));
}

/// The oldest entry leaves the ring and is executed by the runtime that lags behind.
void forget_oldest(axisrt_recorder& recorder) {
  EntryHead const head = unpacked(recorder.words[recorder.first]);
  uint64_t const size = size_of(*recorder.past, head.kind);
  uint64_t const from = place(recorder, 1);
  uint64_t const count = size - 1;
  uint64_t const at_once = before_end(recorder, from, count);
  copy_words(recorder.values, recorder.words + from, at_once);
  copy_words(recorder.values + at_once, recorder.words, count - at_once);
  execute(*recorder.past, head, recorder.values);
  recorder.first = place(recorder, size);
  recorder.used -= size;
  recorder.entries -= 1;
}

axisrt_status execute_command(axisrt& runtime, uint32_t group, double const* values) {
  auto const what = std::bit_cast<uint64_t>(values[0]);
  axisrt_filter_command const command{.size = sizeof(axisrt_filter_command),
                                      .action = static_cast<uint32_t>(what),
                                      .keywords = static_cast<uint32_t>(what >> 32U),
                                      .order = static_cast<uint32_t>(std::bit_cast<uint64_t>(values[1])),
                                      .share = values[2],
                                      .fcut = values[3],
                                      .quality = values[4]};
  return axisrt_command(&runtime, group, &command);
}

}  // namespace

EntrySizes entry_sizes(axisrt const& runtime) {
  bool has_interface = false;
  for (uint32_t i = 0; i < runtime.axis_count; ++i) {
    has_interface = has_interface || runtime.additional_interface.lines[i].filter_count > 0;
  }
  return {.step = size_of(runtime, axrd_step),
          .step_interface = has_interface ? size_of(runtime, axrd_step_interface) : 0,
          .step_velocity = runtime.control_count > 0 ? size_of(runtime, axrd_step_velocity) : 0};
}

uint64_t packed(EntryHead const& head) {
  return head.kind | head.flags << 8U | head.status << 16U | static_cast<uint64_t>(head.index) << 32U;
}

EntryHead unpacked(uint64_t word) {
  constexpr uint64_t octet = 0xFF;
  return {.kind = static_cast<uint32_t>(word & octet),
          .flags = static_cast<uint32_t>(word >> 8U & octet),
          .status = static_cast<uint32_t>(word >> 16U & 0xFFFFU),
          .index = static_cast<uint32_t>(word >> 32U)};
}

Entry::Entry(axisrt_recorder* recorder, uint32_t kind, uint32_t index, uint64_t words)
    : recorder_(words > 0 ? recorder : nullptr), kind_(kind), index_(index) {
  if (recorder_ == nullptr) return;
  while (recorder_->capacity - recorder_->used < words) forget_oldest(*recorder_);
  next_ = 1;
}

void Entry::put(uint64_t word) {
  if (recorder_ == nullptr) return;
  recorder_->words[place(*recorder_, recorder_->used + next_)] = word;
  next_ += 1;
}

void Entry::put(double const* values, uint32_t count) {
  if (recorder_ == nullptr) return;
  if (values == nullptr) {
    for (uint32_t i = 0; i < count; ++i) put(uint64_t{0});
    return;
  }
  uint64_t const to = place(*recorder_, recorder_->used + next_);
  uint64_t const at_once = before_end(*recorder_, to, count);
  copy_words(recorder_->words + to, values, at_once);
  copy_words(recorder_->words, values + at_once, count - at_once);
  next_ += count;
}

void Entry::put(uint8_t const* status, uint32_t count) {
  if (recorder_ == nullptr) return;
  for (uint32_t i = 0; i < count; i += statuses_in_word) {
    uint64_t word = 0;
    for (uint32_t k = 0; k < statuses_in_word && i + k < count && status != nullptr; ++k) {
      word |= static_cast<uint64_t>(status[i + k]) << 8 * k;
    }
    put(word);
  }
}

void Entry::finish(uint32_t flags, axisrt_status status) {
  if (recorder_ == nullptr) return;
  recorder_->words[place(*recorder_, recorder_->used)] =
      packed({.kind = kind_, .flags = flags, .status = static_cast<uint32_t>(status), .index = index_});
  recorder_->used += next_;
  recorder_->entries += 1;
}

void record_call(axisrt const& runtime, EntryHead const& head, double const* values, uint32_t count) {
  if (runtime.recorder == nullptr) return;
  Entry entry(runtime.recorder, head.kind, head.index, 1 + uint64_t{count});
  entry.put(values, count);
  entry.finish(head.flags, static_cast<axisrt_status>(head.status));
}

axisrt_status execute(axisrt& runtime, EntryHead const& head, double* values) {
  uint32_t const n = runtime.axis_count;
  switch (head.kind) {
    case axrd_step: return axisrt_step(&runtime, values, values + n, nullptr);
    case axrd_step_interface: return axisrt_step_interface(&runtime, values, values + n, nullptr);
    case axrd_step_velocity: {
      bool const has_direct = (head.flags & axrd_has_v_direct) != 0;
      axisrt_velocities const in{.size = sizeof(axisrt_velocities),
                                 .reserved = 0,
                                 .v_set = values,
                                 .v_motor = values + n,
                                 .v_direct = has_direct ? values + 2 * uint64_t{n} : nullptr};
      double* const v_add = values + 3 * uint64_t{n};
      return axisrt_step_velocity(&runtime, &in, v_add, v_add + n, nullptr);
    }
    case axrd_reset: return axisrt_reset(&runtime, head.index, values[0]);
    case axrd_reset_interface: return axisrt_reset_interface(&runtime, head.index, values[0]);
    case axrd_reset_velocity:
      return axisrt_reset_velocity(&runtime, head.index, values[0], values[1], values[2]);
    case axrd_rebase: return axisrt_rebase(&runtime, head.index, values[0]);
    default: return execute_command(runtime, head.index, values);
  }
}

}  // namespace axisc::runtime
