// `--measured`.
#pragma once

#include "analysis/tuning/identification/measurement.hpp"
#include "diagnostics/message.hpp"

#include <string>

namespace axisc {

struct MeasuredResonances {
  tuning::MeasurementKind kind = tuning::MeasurementKind::spectrum;
  std::vector<tuning::Peak> peaks;
  std::optional<Message> refusal;  ///< why there are no peaks, and what to record
};

/// Resonances below `highest` Hz. Failure (AX9005) for a file that is no measurement, AX9001 for one that
/// cannot be read.
[[nodiscard]] MeasuredResonances measured_resonances(std::string const& path,
                                                     tuning::SignalColumns const& columns, double highest);

}  // namespace axisc
