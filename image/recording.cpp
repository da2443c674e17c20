#include "image/recording.hpp"

#include "runtime/format/recording_format.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace axisc::image {

namespace {

constexpr std::size_t word_size = 8;
constexpr std::size_t statuses_in_word = 8;

std::uint64_t word_at(std::span<std::byte const> dump, std::size_t index) {
  std::uint64_t word = 0;
  for (std::size_t i = word_size; i-- > 0;) {
    word = word << 8U | std::to_integer<std::uint64_t>(dump[index * word_size + i]);
  }
  return word;
}

/// Words of an entry after its head; 0 for an unknown kind.
std::size_t size_of(std::uint64_t kind, std::size_t axes) {
  std::size_t const status = (axes + statuses_in_word - 1) / statuses_in_word;
  switch (kind) {
    case axrd_step:
    case axrd_step_interface: return 2 * axes + status;
    case axrd_step_velocity: return 5 * axes + status;
    case axrd_reset_velocity: return 3;
    case axrd_command: return axrd_command_words;
    case axrd_reset:
    case axrd_reset_interface:
    case axrd_rebase: return 1;
    default: return 0;
  }
}

/// No status of the runtime is above the last one.
bool is_status(std::uint64_t number) {
  return number <= AXISRT_NOT_WARM;
}

bool same_bits(std::vector<double> const& a, std::vector<double> const& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

}  // namespace

bool ReplayedEntry::same() const {
  return recorded_status == computed_status && same_bits(recorded, computed);
}

Recording::Recording(codegen::AlignedBytes image, codegen::AlignedBytes memory, std::vector<std::byte> dump,
                     axisrt* runtime)
    : image_(std::move(image)),
      memory_(std::move(memory)),
      dump_(std::move(dump)),
      runtime_(runtime),
      at_(axrd_header_words + static_cast<std::size_t>(word_at(dump_, 3))) {}

std::variant<Recording, axisrt_status> Recording::open(std::span<std::byte const> image,
                                                       std::span<std::byte const> dump) {
  codegen::AlignedBytes owned_image(image);
  std::vector<std::byte> owned_dump(dump.begin(), dump.end());
  axisrt_config config{};
  config.size = sizeof config;
  config.image = owned_image.data();
  config.image_size = owned_image.size();
  bool const has_header = dump.size() >= axrd_header_words * word_size;
  // The runtime refuses an invalid level, after it has checked the checksum.
  auto const level = has_header ? static_cast<std::uint32_t>(word_at(dump, 1)) : 0;
  config.level = level == AXISRT_LEVEL_AUTOMATIC ? std::uint32_t{AXISRT_LEVEL_PORTABLE} : level;
  std::size_t size = 0;
  std::size_t alignment = 0;
  axisrt_status const sized = axisrt_memory_size(&config, &size, &alignment);
  if (sized != AXISRT_OK) return sized == AXISRT_NO_LEVEL ? AXISRT_BAD_RECORDING : sized;
  codegen::AlignedBytes memory(size);
  config.memory = memory.data();
  config.memory_size = memory.size();
  axisrt* runtime = nullptr;
  axisrt_status const status = axisrt_restore(&config, owned_dump.data(), owned_dump.size(), &runtime);
  if (status != AXISRT_OK) return status;
  return Recording(std::move(owned_image), std::move(memory), std::move(owned_dump), runtime);
}

std::uint64_t Recording::take() {
  return word_at(dump_, at_++);
}

std::vector<double> Recording::take_numbers(std::size_t count) {
  std::vector<double> numbers(count);
  std::generate(numbers.begin(), numbers.end(), [this] { return std::bit_cast<double>(take()); });
  return numbers;
}

void Recording::take_status(ReplayedEntry& entry, bool given) {
  entry.status.clear();
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < axis_count(); ++i) {
    if (i % statuses_in_word == 0) word = take();
    auto const status = static_cast<std::uint8_t>(word >> 8 * (i % statuses_in_word));
    damaged_ = damaged_ || (given && !is_status(status));
    if (given) entry.status.push_back(status);
  }
}

void Recording::step(ReplayedEntry& entry, std::uint64_t flags) {
  std::size_t const axes = axis_count();
  entry.in = take_numbers(axes);
  entry.recorded = take_numbers(axes);
  entry.computed.resize(axes);
  take_status(entry, (flags & axrd_has_status) != 0);
  auto* const execute = entry.kind == RecordedKind::step ? axisrt_step : axisrt_step_interface;
  entry.computed_status = execute(runtime_, entry.in.data(), entry.computed.data(), nullptr);
}

void Recording::step_velocity(ReplayedEntry& entry, std::uint64_t flags) {
  std::size_t const axes = axis_count();
  entry.in = take_numbers(3 * axes);
  entry.recorded = take_numbers(2 * axes);
  entry.computed.assign(2 * axes, 0);
  take_status(entry, (flags & axrd_has_status) != 0);
  axisrt_velocities velocities{};
  velocities.size = sizeof velocities;
  velocities.v_set = entry.in.data();
  velocities.v_motor = entry.in.data() + axes;
  velocities.v_direct = (flags & axrd_has_v_direct) != 0 ? entry.in.data() + 2 * axes : nullptr;
  double* const increments = (flags & axrd_has_increments) != 0 ? entry.computed.data() + axes : nullptr;
  entry.computed_status =
      axisrt_step_velocity(runtime_, &velocities, entry.computed.data(), increments, nullptr);
}

void Recording::call(ReplayedEntry& entry) {
  entry.recorded.clear();
  entry.computed.clear();
  entry.status.clear();
  if (entry.kind == RecordedKind::command) {
    std::uint64_t const what = take();
    entry.command = {.size = sizeof(axisrt_filter_command),
                     .action = static_cast<std::uint32_t>(what),
                     .keywords = static_cast<std::uint32_t>(what >> 32U),
                     .order = static_cast<std::uint32_t>(take()),
                     .share = std::bit_cast<double>(take()),
                     .fcut = std::bit_cast<double>(take()),
                     .quality = std::bit_cast<double>(take())};
    entry.computed_status = axisrt_command(runtime_, entry.index, &entry.command);
    return;
  }
  entry.in = take_numbers(entry.kind == RecordedKind::reset_velocity ? 3 : 1);
  switch (entry.kind) {
    case RecordedKind::reset: entry.computed_status = axisrt_reset(runtime_, entry.index, entry.in[0]); break;
    case RecordedKind::reset_interface:
      entry.computed_status = axisrt_reset_interface(runtime_, entry.index, entry.in[0]);
      break;
    case RecordedKind::reset_velocity:
      entry.computed_status =
          axisrt_reset_velocity(runtime_, entry.index, entry.in[0], entry.in[1], entry.in[2]);
      break;
    default: entry.computed_status = axisrt_rebase(runtime_, entry.index, entry.in[0]); break;
  }
}

bool Recording::next(ReplayedEntry& entry) {
  std::size_t const end = dump_.size() / word_size;
  if (at_ == end) return false;
  std::uint64_t const head = word_at(dump_, at_);
  std::uint64_t const kind = head & 0xFFU;
  std::uint64_t const flags = head >> 8U & 0xFFU;
  std::size_t const size = size_of(kind, axis_count());
  std::uint64_t const status = head >> 16U & 0xFFFFU;
  damaged_ = size == 0 || size > end - at_ - 1 || !is_status(status);
  if (damaged_) return false;
  at_ += 1;
  entry.kind = static_cast<RecordedKind>(kind - axrd_step);
  entry.recorded_status = static_cast<axisrt_status>(status);
  entry.index = static_cast<std::uint32_t>(head >> 32U);
  entry.cycle = cycle_;
  switch (entry.kind) {
    case RecordedKind::step: cycle_ += 1; [[fallthrough]];
    case RecordedKind::step_interface: step(entry, flags); break;
    case RecordedKind::step_velocity: step_velocity(entry, flags); break;
    default: call(entry); break;
  }
  return !damaged_;
}

}  // namespace axisc::image
