// Any sequence of calls on a runtime that has everything: commands, resets, new origins, changes of image,
// good and bad setpoints. Outputs stay finite, statuses are those that axisrt.h names, and what was recorded
// replays bit for bit.
#include "axisrt.h"
#include "image/recording.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace {

using namespace axisc::test;

void require(bool condition) {
  if (!condition) std::abort();
}

/// What the fuzzer decides; zeros behind its end.
class Choices {
 public:
  Choices(std::uint8_t const* data, std::size_t size) : data_(data), size_(size) {}
  [[nodiscard]] bool ended() const { return at_ >= size_; }
  std::uint8_t octet() { return ended() ? std::uint8_t{0} : data_[at_++]; }
  /// Mostly a small increment, at times a number from the edges.
  double number(double near) {
    constexpr double edges[] = {0.0,
                                -0.0,
                                0x1p53,
                                -0x1p53,
                                0x1p54,
                                1e308,
                                5e-324,
                                0x1p-31,
                                0x1p-40,
                                -1e-9,
                                1e9,
                                -1e9,
                                std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::quiet_NaN()};
    std::uint8_t const choice = octet();
    if (choice < 200) return near + (static_cast<int>(octet()) - 128) * (choice < 150 ? 1.0 : 0.001);
    return edges[choice % std::size(edges)];
  }

 private:
  std::uint8_t const* data_;
  std::size_t size_;
  std::size_t at_ = 0;
};

Bytes image_bytes() {
  ImageRecord image = channel_image();
  image.axes[1].interface_filters = complete_image().axes[1].interface_filters;
  return write_image(image);
}

/// A runtime with a recorder, and the one that may replace it.
class Machine {
 public:
  Machine()
      : bytes_(image_bytes()), image_(bytes_), memory_(size_of_runtime()), last_(3, 0.0), in_(3), out_(3) {
    axisrt_config config = config_for(memory_);
    require(axisrt_create(&config, &runtime_) == AXISRT_OK);
    start_recorder();
  }

  void call(Choices& choices) {
    std::uint32_t const axis = choices.octet() % 4;  // one of them is none
    switch (choices.octet() % 16) {
      case 0:
        require_one_of(axisrt_reset(runtime_, axis, choices.number(0)),
                       {AXISRT_OK, AXISRT_BAD_INPUT, AXISRT_BAD_ARGUMENT});
        break;
      case 1:
        require_one_of(axisrt_reset_interface(runtime_, axis, choices.number(0)),
                       {AXISRT_OK, AXISRT_BAD_INPUT, AXISRT_BAD_ARGUMENT});
        break;
      case 2:
        require_one_of(
            axisrt_reset_velocity(runtime_, axis, choices.number(0), choices.number(0), choices.number(0)),
            {AXISRT_OK, AXISRT_BAD_INPUT, AXISRT_BAD_ARGUMENT});
        break;
      case 3:
        require_one_of(axisrt_rebase(runtime_, axis, choices.number(3600)),
                       {AXISRT_OK, AXISRT_BAD_INPUT, AXISRT_BAD_ARGUMENT, AXISRT_NOT_RESET});
        break;
      case 4:
      case 5: command(choices); break;
      case 6: change_image(choices); break;
      case 7: query(axis); break;
      default: step(choices); break;
    }
  }

  /// The recording gives the same again.
  void check_recording() {
    axisrt_recorder_stop(recorder_);
    if (recorder_ == nullptr) return;
    std::size_t size = 0;
    require(axisrt_recorder_dump(recorder_, nullptr, 0, &size) == AXISRT_MEMORY_TOO_SMALL);
    std::vector<std::byte> dump(size);
    require(axisrt_recorder_dump(recorder_, dump.data(), size, &size) == AXISRT_OK);
    auto recording = axisc::image::Recording::open(std::as_bytes(std::span(bytes_)), dump);
    require(std::holds_alternative<axisc::image::Recording>(recording));
    axisc::image::ReplayedEntry entry;
    auto& replayed = std::get<axisc::image::Recording>(recording);
    while (replayed.next(entry)) require(entry.same());
    require(!replayed.damaged());
  }

 private:
  static void require_one_of(axisrt_status status, std::initializer_list<axisrt_status> expected) {
    for (axisrt_status const one : expected) {
      if (status == one) return;
    }
    std::abort();
  }

  [[nodiscard]] axisrt_config config_for(AlignedMemory& memory) const {
    return {.size = sizeof(axisrt_config),
            .cycle_time_ns = 1'000'000,
            .image = image_.data(),
            .image_size = image_.size(),
            .memory = memory.data(),
            .memory_size = memory.size(),
            .level = AXISRT_LEVEL_AUTOMATIC,
            .reserved = 0,
            .verify_signature = nullptr,
            .verify_context = nullptr};
  }
  [[nodiscard]] std::size_t size_of_runtime() const {
    AlignedMemory nothing(0);
    axisrt_config const config = config_for(nothing);
    std::size_t size = 0;
    std::size_t alignment = 0;
    require(axisrt_memory_size(&config, &size, &alignment) == AXISRT_OK);
    return size;
  }

  void start_recorder() {
    axisrt_config config = config_for(memory_);
    std::size_t size = 0;
    require(axisrt_recorder_size(runtime_, &config, 16, &size) == AXISRT_OK);
    recorder_memory_ = std::make_unique<AlignedMemory>(size);
    config.memory = recorder_memory_->data();
    config.memory_size = size;
    require(axisrt_recorder_start(runtime_, &config, 16, &recorder_) == AXISRT_OK);
  }

  void command(Choices& choices) {
    axisrt_filter_command command{};
    command.size = sizeof command;
    command.action = choices.octet() % 5;
    command.keywords = choices.octet() % 32;
    command.order = choices.octet() % 2 == 0 ? 8 : 3;
    command.share = choices.octet() % 2 == 0 ? 50 : choices.number(50);
    command.fcut = 80;
    command.quality = 0.5;
    require_one_of(axisrt_command(runtime_, choices.octet() % 8 == 0 ? 1 : 0, &command),
                   {AXISRT_OK, AXISRT_BUSY, AXISRT_NO_BANK, AXISRT_NEEDS_STANDSTILL, AXISRT_BAD_ARGUMENT});
  }

  /// Prepares, shadows and swaps; ends the recording when the swap is done.
  void change_image(Choices& choices) {
    if (next_ == nullptr) {
      next_memory_ = std::make_unique<AlignedMemory>(size_of_runtime());
      axisrt_config const config = config_for(*next_memory_);
      require_one_of(axisrt_prepare(runtime_, &config, choices.octet() % 2, &next_),
                     {AXISRT_OK, AXISRT_BUSY});
      return;
    }
    axisrt_status const status = axisrt_swap(next_);
    require_one_of(status, {AXISRT_OK, AXISRT_BUSY, AXISRT_NEEDS_STANDSTILL, AXISRT_NOT_WARM});
    if (status != AXISRT_OK) return;
    check_recording();
    recorder_ = nullptr;
    old_memory_ = std::move(current_memory_);
    current_memory_ = std::move(next_memory_);
    runtime_ = next_;
    next_ = nullptr;
  }

  void query(std::uint32_t axis) {
    axisrt_axis_state state{};
    if (axisrt_get_axis_state(runtime_, axis, &state) == AXISRT_OK) {
      require(std::isfinite(state.filtered) && std::isfinite(state.unfiltered));
      for (double const value : state.filter_output) require(std::isfinite(value));
    }
    double bound = 0;
    if (axisrt_axis_error_bound(runtime_, axis, 1000, &bound) == AXISRT_OK) require(bound >= 0);
  }

  void step(Choices& choices) {
    for (std::size_t i = 0; i < in_.size(); ++i) {
      in_[i] = choices.number(last_[i]);
      if (std::isfinite(in_[i])) last_[i] = in_[i];
    }
    std::uint8_t status[3] = {};
    bool const asks = choices.octet() % 2 == 0;
    auto const good = {AXISRT_OK, AXISRT_BAD_INPUT, AXISRT_NOT_RESET, AXISRT_IMPLAUSIBLE};
    require_one_of(axisrt_step(runtime_, in_.data(), out_.data(), asks ? status : nullptr), good);
    for (double const out : out_) require(std::isfinite(out));
    if (asks) {
      for (std::uint8_t const one : status) require_one_of(static_cast<axisrt_status>(one), good);
    }
    if (next_ != nullptr) require(axisrt_shadow_step(next_) == AXISRT_OK);
    if (choices.octet() % 2 == 0) return;
    require_one_of(axisrt_step_interface(runtime_, in_.data(), out_.data(), status), good);
    for (double const out : out_) require(std::isfinite(out));
    axisrt_velocities velocities{};
    velocities.size = sizeof velocities;
    velocities.v_set = velocities.v_motor = in_.data();
    double increments[3] = {};
    require_one_of(axisrt_step_velocity(runtime_, &velocities, out_.data(), increments, status), good);
    for (double const out : out_) require(std::isfinite(out));
    for (double const increment : increments) require(std::isfinite(increment));
  }

  Bytes bytes_;
  AlignedMemory image_;
  AlignedMemory memory_;
  std::unique_ptr<AlignedMemory> recorder_memory_, next_memory_, current_memory_, old_memory_;
  axisrt* runtime_ = nullptr;
  axisrt* next_ = nullptr;
  axisrt_recorder* recorder_ = nullptr;
  std::vector<double> last_, in_, out_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  Choices choices(data, size);
  Machine machine;
  for (int calls = 0; calls < 4000 && !choices.ended(); ++calls) machine.call(choices);
  machine.check_recording();
  return 0;
}
