// The position and the force of an axis in a recording, for `identify`.
#pragma once

#include "analysis/tuning/rigid_model/motion_windows.hpp"
#include "axisc/answers/execution/recorded_scale.hpp"
#include "axisc/answers/identify/force_unit.hpp"
#include "axisc/files/recorded_choice.hpp"
#include "configuration/machine/machine.hpp"
#include "image/image_contents.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace axisc {

/// Names of columns, or their numbers from 1.
struct MotionColumns {
  std::optional<std::string> actual = {}, force = {};
};

/// The axis that was recorded, and its control.
struct MovedAxis {
  AxisPlace place;
  image::ImageAxis const& configured;
  double cycle_ms = 0;  ///< of the NC: a recording without times has a sample a cycle

  [[nodiscard]] bool is_rotary() const {
    return configured.type != static_cast<std::uint32_t>(machine::AxisType::translatory);
  }
};

struct MotionSignals {
  tuning::MotionRecord record;  ///< position in m or rad, force in units of `force`
  double sample_time_ms = 0;
  bool is_unit_guessed = false;  ///< that of the position: see ColumnScale
  ForceUnit force;
  std::array<MappedColumn, 2> mapping;  ///< position and force
};

/// Columns that are not named are the actual position and the torque of the axis, by object or by the names
/// of a template, or the only ones whose names say so ("Position X [mm]", "Torque [Nm]"). Failure (AX9005)
/// where they have to be named, and for samples that are missing.
[[nodiscard]] MotionSignals motion_signals(RecordingFile const& file, MovedAxis const& axis,
                                           MotionColumns const& columns, PositionUnits const& units);

}  // namespace axisc
