// Restores the state with which a recording begins.
#include "axisrt.h"
#include "runtime/configuration.hpp"
#include "runtime/control_word.hpp"
#include "runtime/limits.hpp"
#include "runtime/little_endian.hpp"
#include "runtime/recording.hpp"

#include <bit>
#include <limits>

namespace axisc::runtime {
namespace {

/// Larger than the states of any sound filter; from here on states are bounded before anything could
/// overflow.
constexpr double largest_restored = 0x1p256;

/// Reads states into a new runtime, and refuses those that no cycle can leave.
class Reader {
 public:
  explicit Reader(uint8_t const* from) : from_(from) {}

  bool number(uint32_t /*from*/, uint32_t& to, uint32_t largest) {
    uint64_t const word = take();
    to = static_cast<uint32_t>(word);
    return word <= largest;
  }

  /// Expects that the lines that were never reset are counted in the batch's state.
  bool states(Batch const& /*from*/, Batch const& to) {
    uint32_t never_reset = 0;
    bool good = true;
    for (uint64_t i = 0; i < count_states(to); ++i) {
      auto const row = static_cast<uint32_t>(i % to.state_stride / to.width);
      uint64_t const bits = take();
      good = good && is_possible(to, row, bits);
      if (row == GroupParts::reset_done && bits == 0) never_reset += 1;
      to.states[i] = std::bit_cast<double>(bits);
    }
    return good && never_reset == to.state->never_reset && others_count_as_reset(to);
  }

 private:
  uint64_t take() {
    uint64_t const word = load_u64(from_);
    from_ += word_size;
    return word;
  }

  static bool is_possible(Batch const& batch, uint32_t row, uint64_t bits) {
    auto const value = std::bit_cast<double>(bits);
    switch (row) {
      case GroupParts::input: return is_within(value, largest_position) && is_multiple(value, grid);
      case GroupParts::reset_done: return bits == 0 || bits == all_set;
      case GroupParts::largest_increment:
        return bits <= std::bit_cast<uint64_t>(std::numeric_limits<double>::infinity()) &&
               is_multiple(value, grid);
      default:
        return is_within(value, largest_restored) &&
               is_multiple(value, is_fine(batch, row) ? fine_grid : grid);
    }
  }

  /// Outputs, e of sections, and the sums that kernels have prepared ahead.
  static bool is_fine(Batch const& batch, uint32_t row) {
    if (row < GroupParts::operations) return true;
    uint32_t last = 0;
    for (uint32_t i = 1; i < batch.operation_count; ++i) {
      if (batch.operations[i].first_state <= row) last = i;
    }
    Operation const& operation = batch.operations[last];
    uint32_t const place = row - operation.first_state;
    switch (operation.kind) {
      case OperationKind::delay: return false;
      case OperationKind::slot: return place >= SlotParts::ahead && place < SlotParts::history;
      default: return place % 2 == 0;
    }
  }

  static bool is_multiple(double value, double unit) {
    return is_within(unit, magnitude(value)) || on_grid(value, unit) == value;
  }

  /// Lanes without a line of their own.
  static bool others_count_as_reset(Batch const& batch) {
    double const* const last = batch.states + count_states(batch) - batch.state_stride;
    for (uint32_t lane = batch.used_in_last; lane < batch.width; ++lane) {
      if (std::bit_cast<uint64_t>(last[GroupParts::reset_done * batch.width + lane]) != all_set) return false;
    }
    return true;
  }

  uint8_t const* from_;
};

bool is_sound(uint8_t const* dump, uint64_t size) {
  if (size < header_size || size % word_size != 0) return false;
  if (dump[0] != 'A' || dump[1] != 'X' || dump[2] != 'R' || dump[3] != 'D') return false;
  if (load_u16(dump + 4) != axrd_major) return false;
  uint64_t const state = load_u64(dump + 3 * word_size);
  uint64_t const entries = load_u64(dump + 4 * word_size);
  uint64_t const words = size / word_size - axrd_header_words;
  if (state > words || entries != words - state) return false;
  return load_u32(dump + content_checksum_place) == content_checksum(dump, size) &&
         load_u32(dump + header_checksum_place) == header_checksum(dump);
}

axisrt_status restore(axisrt_config const& config, uint8_t const* dump, uint64_t size, axisrt*& runtime) {
  if (!is_sound(dump, size)) return AXISRT_BAD_RECORDING;
  axisrt_config config_of_dump = config;
  config_of_dump.level = load_u32(dump + word_size);
  config_of_dump.cycle_time_ns = load_u32(dump + 2 * word_size);
  if (config_of_dump.level == AXISRT_LEVEL_AUTOMATIC) return AXISRT_BAD_RECORDING;
  axisrt* made = nullptr;
  axisrt_status const status = create_beside(config_of_dump, {.first = dump, .size = size}, {}, made);
  if (status == AXISRT_OTHER_CYCLE_TIME) return AXISRT_OTHER_IMAGE;
  if (status != AXISRT_OK) return status;
  if (made->payload_checksum != load_u32(dump + 2 * word_size + 4)) return AXISRT_OTHER_IMAGE;
  if (made->axis_count != load_u32(dump + word_size + 4)) return AXISRT_OTHER_IMAGE;
  if (count_state_words(*made) != load_u64(dump + 3 * word_size)) return AXISRT_BAD_RECORDING;
  Reader reader(dump + header_size);
  if (!walk(*made, *made, reader)) return AXISRT_BAD_RECORDING;
  runtime = made;
  return AXISRT_OK;
}

}  // namespace
}  // namespace axisc::runtime

axisrt_status axisrt_restore(axisrt_config const* config, void const* dump, size_t size, axisrt** runtime) {
  using namespace axisc::runtime;
  if (runtime == nullptr) return AXISRT_BAD_ARGUMENT;
  *runtime = nullptr;
  if (!is_known(config) || dump == nullptr) return AXISRT_BAD_ARGUMENT;
  return in_plain_arithmetic(
      [&] { return restore(*config, static_cast<uint8_t const*>(dump), size, *runtime); });
}
