// An axis' setpoint chain beside what a scope recorded of it.
#pragma once

#include "analysis/comparison/telling_motion.hpp"
#include "analysis/comparison/verdict.hpp"
#include "axisc/answers/execution/recorded_units.hpp"
#include "axisc/files/recorded_columns.hpp"
#include "image/image_contents.hpp"

namespace axisc {

/// Motions that are proposed: in mm or degrees.
inline constexpr double telling_step = 1;
inline constexpr double telling_feed = 6000;  ///< per minute

struct RecordedAxis {
  RecordedColumns columns;
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

/// The named axis, or the only one of the image `file`. Failure where there are several.
[[nodiscard]] std::size_t recorded_axis(image::ImageContents const& image,
                                        std::optional<std::string> const& name, std::string const& file);

/// `switches` of kernel_switches(), in cycles of the recording; where there are none, such that explain it
/// are looked for. Failures as those of read_recorded_columns().
[[nodiscard]] RecordedAxis compare_axis(image::ImageContents const& image, std::size_t axis,
                                        std::string const& path, WantedColumns const& columns,
                                        RecordedUnit unit,
                                        std::vector<comparison::KernelSwitch> switches = {});

}  // namespace axisc
