// `--measured`.
#pragma once

#include "analysis/tuning/identification/measurement.hpp"
#include "axisc/answers/execution/recorded_scale.hpp"
#include "axisc/files/recorded_choice.hpp"
#include "diagnostics/message.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc {

struct MeasuredResonances {
  tuning::MeasurementKind kind = tuning::MeasurementKind::spectrum;
  std::vector<MappedColumn> mapping;  ///< of signals: input and output
  std::vector<tuning::Peak> peaks;
  std::optional<Message> refusal;  ///< why there are no peaks, and what to record
};

/// Names of the columns with the input and the output of signals, or their numbers from 1.
struct SignalColumns {
  std::optional<std::string> in = {}, out = {};
};

/// Resonances below `highest` Hz. Columns of signals that are not named are the torque and the velocity of
/// the axis, or its command and actual position, or the only two of a text without a scope's header. Failure
/// (AX9005) for a file that is no measurement, AX9001 for one that cannot be read.
[[nodiscard]] MeasuredResonances measured_resonances(std::string const& path, AxisPlace const& axis,
                                                     SignalColumns const& columns, double highest);

}  // namespace axisc
