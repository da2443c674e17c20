// The signals of a recording for `--measured`.
#pragma once

#include "analysis/tuning/identification/measurement.hpp"
#include "axisc/answers/execution/recorded_scale.hpp"
#include "axisc/files/recorded_choice.hpp"

#include <array>
#include <optional>
#include <string>

namespace axisc {

/// Names of the columns with the input and the output of signals, or their numbers from 1.
struct SignalColumns {
  std::optional<std::string> in = {}, out = {};
};

/// The axis that was recorded, and its control.
struct MeasuredAxis {
  AxisPlace place;
  bool is_rotary = false;
  double cycle_ms = 0;    ///< of the NC: a recording without times has a sample a cycle
  double highest_hz = 0;  ///< resonances above it are not looked for
};

struct MeasuredSignals {
  tuning::Measurement measurement;
  std::array<MappedColumn, 2> mapping;  ///< input and output
  /// Of the setpoint: "mm" or "°", into which its values were converted, or what the file says, or nothing.
  std::string unit;
};

/// Columns that are not named are the torque and the velocity of the axis, or its command and actual
/// position, or the only two of a text without a scope's header. Failure (AX9005) where they have to be
/// named, and for samples that are missing.
[[nodiscard]] MeasuredSignals measured_signals(RecordingFile const& file, MeasuredAxis const& axis,
                                               SignalColumns const& columns);

}  // namespace axisc
