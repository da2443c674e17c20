// A recording of the runtime (axisrt_recorder), executed again entry by entry.
#pragma once

#include "axisrt.h"
#include "codegen/aligned_bytes.hpp"
#include "configuration/machine/filter_command.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

namespace axisc::image {

enum class RecordedKind : std::uint8_t {
  step,
  step_interface,
  step_velocity,
  reset,
  reset_interface,
  reset_velocity,
  rebase,
  command
};

/// A call, its results when it was recorded, and its results now.
struct ReplayedEntry {
  RecordedKind kind = RecordedKind::step;
  std::uint64_t cycle = 0;  ///< calls of axisrt_step before this one
  std::uint32_t index = 0;  ///< axis, or group of a command
  std::vector<double> in;   ///< of all axes, one port's after the other; the numbers of a call between cycles
  std::vector<double> recorded, computed;  ///< outputs, likewise
  std::vector<std::uint8_t> status;        ///< of all axes; empty where the controller did not ask for it
  axisrt_status recorded_status = AXISRT_OK, computed_status = AXISRT_OK;
  axisrt_filter_command command{};

  /// Bit for bit, with the status.
  [[nodiscard]] bool same() const;
};

class Recording {
 public:
  /// Checks the dump, and puts a runtime of the recorded level into its first state. A status of
  /// axisrt_restore otherwise.
  [[nodiscard]] static std::variant<Recording, axisrt_status> open(std::span<std::byte const> image,
                                                                   std::span<std::byte const> dump);

  /// An axisrt_level.
  [[nodiscard]] std::uint32_t level() const { return axisrt_level_of(runtime_); }
  [[nodiscard]] std::uint32_t axis_count() const { return axisrt_axis_count(runtime_); }
  /// Executes the next entry; false at the end, or where the rest is not an entry (`damaged`).
  [[nodiscard]] bool next(ReplayedEntry& entry);
  [[nodiscard]] bool damaged() const { return damaged_; }

 private:
  Recording(codegen::AlignedBytes image, codegen::AlignedBytes memory, std::vector<std::byte> dump,
            axisrt* runtime);
  [[nodiscard]] std::uint64_t take();
  [[nodiscard]] std::vector<double> take_numbers(std::size_t count);
  void take_status(ReplayedEntry& entry, bool given);
  void step(ReplayedEntry& entry, std::uint64_t flags);
  void step_velocity(ReplayedEntry& entry, std::uint64_t flags);
  void call(ReplayedEntry& entry);

  codegen::AlignedBytes image_, memory_;
  std::vector<std::byte> dump_;
  axisrt* runtime_;  ///< lies in memory_
  std::size_t at_ = 0;
  std::uint64_t cycle_ = 0;
  bool damaged_ = false;
};

}  // namespace axisc::image
