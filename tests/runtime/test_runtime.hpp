// A runtime made from an image, with its memory.
#pragma once

#include "axisrt.h"
#include "runtime/aligned_memory.hpp"
#include "runtime/exact_filter.hpp"
#include "runtime/image_builder.hpp"

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

namespace axisc::test {

/// The instruction set under test: an axisrt_level in the environment, else the best one.
inline std::uint32_t test_level() {
  char const* const level = std::getenv("AXISRT_TEST_LEVEL");
  return level == nullptr ? std::uint32_t{AXISRT_LEVEL_AUTOMATIC}
                          : static_cast<std::uint32_t>(std::strtoul(level, nullptr, 10));
}

class TestRuntime {
 public:
  explicit TestRuntime(Bytes const& image, std::uint32_t cycle_time_ns = 1'000'000,
                       std::uint32_t level = test_level())
      : image_(std::make_unique<AlignedMemory>(image)) {
    axisrt_config config{.size = sizeof(axisrt_config),
                         .cycle_time_ns = cycle_time_ns,
                         .image = image_->data(),
                         .image_size = image_->size(),
                         .memory = nullptr,
                         .memory_size = 0,
                         .level = level,
                         .reserved = 0,
                         .verify_signature = nullptr,
                         .verify_context = nullptr};
    std::size_t alignment = 0;
    status = axisrt_memory_size(&config, &memory_size, &alignment);
    if (status != AXISRT_OK) return;
    memory_ = std::make_unique<AlignedMemory>(memory_size);
    config.memory = memory_->data();
    config.memory_size = memory_size;
    status = axisrt_create(&config, &runtime);
    if (status == AXISRT_NO_LEVEL) std::puts(axisrt_status_name(status));  // the test is skipped
  }

  /// One cycle of the first axis.
  double step(double in) {
    std::vector<double> const inputs(axisrt_axis_count(runtime), in);
    std::vector<double> outputs(inputs.size());
    status = axisrt_step(runtime, inputs.data(), outputs.data(), nullptr);
    return outputs.front();
  }
  double step_interface(double in) {
    std::vector<double> const inputs(axisrt_axis_count(runtime), in);
    std::vector<double> outputs(inputs.size());
    status = axisrt_step_interface(runtime, inputs.data(), outputs.data(), nullptr);
    return outputs.front();
  }
  /// One cycle of all axes.
  std::vector<double> step_all(std::vector<double> const& in) {
    std::vector<double> out(in.size());
    status = axisrt_step(runtime, in.data(), out.data(), nullptr);
    return out;
  }
  void reset_all(double position) {
    for (std::uint32_t axis = 0; axis < axisrt_axis_count(runtime); ++axis) {
      status = axisrt_reset(runtime, axis, position);
    }
  }
  /// Of the first group.
  axisrt_status command(axisrt_action action, std::uint32_t keywords = 0, std::uint32_t order = 0,
                        double share = 0) {
    axisrt_filter_command const command{.size = sizeof(axisrt_filter_command),
                                        .action = static_cast<std::uint32_t>(action),
                                        .keywords = keywords,
                                        .order = order,
                                        .share = share,
                                        .fcut = 80,
                                        .quality = 0.5};
    return axisrt_command(runtime, 0, &command);
  }
  [[nodiscard]] axisrt_axis_state state(std::uint32_t axis = 0) const {
    axisrt_axis_state state{};
    static_cast<void>(axisrt_get_axis_state(runtime, axis, &state));
    return state;
  }

  axisrt* runtime = nullptr;
  axisrt_status status = AXISRT_OK;
  std::size_t memory_size = 0;

 private:
  std::unique_ptr<AlignedMemory> image_;
  std::unique_ptr<AlignedMemory> memory_;
};

/// An image of one axis with these filters on its setpoint.
inline Bytes one_axis_image(std::vector<ExactFilter> const& filters,
                            std::uint32_t cycle_time_ns = 1'000'000) {
  AxisRecord axis;
  axis.name = "X";
  for (ExactFilter const& filter : filters) {
    axis.filters.push_back(filter.record());
    axis.filters.back().index = static_cast<std::uint32_t>(axis.filters.size() - 1);
  }
  ImageRecord image;
  image.cycle_time_ns = cycle_time_ns;
  image.axes.push_back(std::move(axis));
  return write_image(image);
}

/// An image of one axis with a kernel that works from start-up, in front of (family 1) or behind (2) these
/// filters.
inline Bytes kernel_image(KernelRecord const& kernel, std::uint32_t family = 2,
                          std::vector<ExactFilter> const& filters = {},
                          std::uint32_t cycle_time_ns = 1'000'000) {
  ImageRecord image;
  image.cycle_time_ns = cycle_time_ns;
  image.axes.emplace_back();
  for (ExactFilter const& filter : filters) {
    image.axes[0].filters.push_back(filter.record());
    image.axes[0].filters.back().index = static_cast<std::uint32_t>(image.axes[0].filters.size() - 1);
  }
  image.kernels = {kernel};
  image.slots = {{.family = family, .history = static_cast<std::uint32_t>(kernel.tails.size())}};
  return write_image(image);
}

/// Two axes with everything in it that an image of format 1.0
/// may have: sections of both kinds, a delay, a share, an interface filter,
/// self-tests, names and a source map.
[[nodiscard]] ImageRecord complete_image();

/// A channel of three axes with everything that kernels and position control bring: X with a PT1, a FIR
/// kernel from start-up and two stages; Y with an HSC kernel that a command switches on, then a low-pass; Z
/// without filters, X's gantry slave. Banks: the lists' values, ORDER=8 (standstill only), ORDER=3 SHARE=50,
/// FCUT=80, QUALITY=0.5, HSC.
[[nodiscard]] ImageRecord channel_image();

}  // namespace axisc::test
