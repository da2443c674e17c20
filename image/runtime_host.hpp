// The real-time runtime for programs that may allocate: it owns image and memory, and executes axisrt itself,
// so that `run`, plots and tests show what a controller would do.
#pragma once

#include "axisrt.h"
#include "codegen/aligned_bytes.hpp"
#include "configuration/machine/filter_command.hpp"
#include "design/units.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace axisc::image {

/// Bytes that the runtime needs for an image at an axisrt_level, also at one that this processor lacks.
/// Expects a verified image and a known level.
[[nodiscard]] std::size_t runtime_memory(std::span<std::byte const> image, std::uint32_t level);

class RuntimeHost {
 public:
  /// Copies and verifies the image and runs its self-tests. Without `cycle_time` the controller is taken to
  /// run at the image's own; `level` is an axisrt_level; portable gives the same results on every host.
  /// Throws std::bad_alloc only.
  [[nodiscard]] static std::variant<RuntimeHost, axisrt_status> create(
      std::span<std::byte const> image, std::optional<design::CycleTime> cycle_time = std::nullopt,
      std::uint32_t level = AXISRT_LEVEL_PORTABLE);

  [[nodiscard]] std::uint32_t axis_count() const { return axisrt_axis_count(runtime_); }
  [[nodiscard]] design::CycleTime cycle_time() const { return {axisrt_cycle_time_ns(runtime_)}; }
  /// Empty in a stripped image.
  [[nodiscard]] std::string_view axis_name(std::uint32_t axis) const;
  [[nodiscard]] bool has_interface(std::uint32_t axis) const {
    return axisrt_has_interface(runtime_, axis) != 0;
  }
  [[nodiscard]] bool has_position_control(std::uint32_t axis) const {
    return axisrt_has_position_control(runtime_, axis) != 0;
  }
  [[nodiscard]] std::uint32_t group_count() const { return axisrt_group_count(runtime_); }
  /// Bytes that a controller has to provide.
  [[nodiscard]] std::size_t memory_size() const { return memory_.size(); }

  [[nodiscard]] axisrt_status reset(std::uint32_t axis, double position) {
    return axisrt_reset(runtime_, axis, position);
  }
  [[nodiscard]] axisrt_status reset_interface(std::uint32_t axis, double value) {
    return axisrt_reset_interface(runtime_, axis, value);
  }
  [[nodiscard]] axisrt_status reset_velocity(std::uint32_t axis, double v_set, double v_motor,
                                             double v_direct) {
    return axisrt_reset_velocity(runtime_, axis, v_set, v_motor, v_direct);
  }
  /// Executes a #FILTER command for a group. Parameters are ignored for OFF.
  [[nodiscard]] axisrt_status command(std::uint32_t group, machine::FilterCommand const& command);
  /// The end of an NC program.
  [[nodiscard]] axisrt_status end_program(std::uint32_t group);
  /// All axes, their interfaces and velocities too; the worst status.
  [[nodiscard]] axisrt_status reset_all(double position);
  [[nodiscard]] axisrt_status rebase(std::uint32_t axis, double offset) {
    return axisrt_rebase(runtime_, axis, offset);
  }

  /// One cycle. The spans have axis_count() entries (`status` may be empty), `in` may be `out`; other sizes
  /// are AXISRT_BAD_ARGUMENT.
  [[nodiscard]] axisrt_status step(std::span<double const> in, std::span<double> out,
                                   std::span<std::uint8_t> status = {});
  [[nodiscard]] axisrt_status step_interface(std::span<double const> in, std::span<double> out,
                                             std::span<std::uint8_t> status = {});

  /// Velocities of all axes; the direct measuring system's may be empty.
  struct Velocities {
    std::span<double const> set, motor, direct;
  };
  [[nodiscard]] axisrt_status step_velocity(Velocities const& in, std::span<double> v_add,
                                            std::span<double> increments,
                                            std::span<std::uint8_t> status = {});

  [[nodiscard]] std::variant<axisrt_axis_state, axisrt_status> axis_state(std::uint32_t axis) const;

  /// Records inputs and outputs of the last `cycles` cycles from now on.
  [[nodiscard]] axisrt_status record(std::uint32_t cycles);
  /// The recording, as axisrt_recorder_dump writes it; empty without a recorder.
  [[nodiscard]] std::vector<std::byte> recording() const;

 private:
  RuntimeHost(codegen::AlignedBytes image, codegen::AlignedBytes memory, axisrt* runtime);
  [[nodiscard]] axisrt_config configuration() const;
  [[nodiscard]] bool fits(std::span<double const> in, std::span<double> out,
                          std::span<std::uint8_t> status) const;

  codegen::AlignedBytes image_;
  codegen::AlignedBytes memory_;
  axisrt* runtime_;  ///< lies in memory_
  codegen::AlignedBytes recorder_memory_{0};
  axisrt_recorder* recorder_ = nullptr;
};

}  // namespace axisc::image
