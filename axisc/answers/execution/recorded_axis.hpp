// An axis' setpoint chain beside what a scope recorded of it.
#pragma once

#include "analysis/comparison/telling_motion.hpp"
#include "analysis/comparison/verdict.hpp"
#include "axisc/answers/execution/recorded_scale.hpp"
#include "axisc/files/recorded_columns.hpp"
#include "configuration/machine/machine.hpp"
#include "image/image_contents.hpp"

#include <vector>

namespace axisc {

/// Motions that are proposed: in mm or degrees.
inline constexpr double telling_step = 1;
inline constexpr double telling_feed = 6000;  ///< per minute

struct RecordedAxis {
  RecordedColumns columns;
  std::vector<MappedColumn> mapping;          ///< of the input and of the output
  std::vector<comparison::Reading> readings;  ///< the first is what axisc computes
  comparison::Comparison result;
  double thousandths = 1;  ///< µm, or 0.001°, in a unit of the recording
  bool is_guard = false;   ///< what the commands switch is a Vibration Guard
  bool is_rotary = false;
  std::vector<comparison::KernelSwitch>
      found_switches{};   ///< not given with `--at`; without them nothing fits
  std::size_t jumps = 0;  ///< by a modulo range, most often a full turn; they are taken out
  /// What would tell the readings apart that fit, where there are several.
  std::optional<comparison::Motion> telling{};
  [[nodiscard]] std::string unit() const { return is_rotary ? "0.001°" : "µm"; }
};

/// What is compared: an image, and the machine from which it was compiled, unless it is read as it is.
struct RecordedMachine {
  std::string path;  ///< as the user names it
  image::ImageContents const& image;
  machine::Machine const* machine = nullptr;
};

/// The named axis, the only one, or the only one that the recording shows before and after its filters.
/// Failure where there are several.
[[nodiscard]] std::size_t recorded_axis(RecordedMachine const& machine,
                                        std::optional<std::string> const& name, RecordingFile const& file);

/// `switches` of kernel_switches(), in cycles of the recording; where there are none, such that explain it
/// are looked for. Failures as those of read_recorded_columns() and column_scale().
[[nodiscard]] RecordedAxis compare_axis(RecordedMachine const& machine, std::size_t axis,
                                        RecordingFile const& file, WantedColumns const& columns,
                                        PositionUnits const& units,
                                        std::vector<comparison::KernelSwitch> switches = {});

}  // namespace axisc
