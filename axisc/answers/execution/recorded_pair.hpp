// Two columns of a recording that belong together, sample by sample.
#pragma once

#include "axisc/files/recorded_choice.hpp"
#include "axisc/files/recording_file.hpp"

#include <array>

namespace axisc {

struct RecordedPair {
  recordings::CycleSignals signals;  ///< of both columns, without gaps
  double sample_time_ms = 0;
};

/// A recording without times has a sample every `cycle_ms`. Failure (AX9005) for columns with different
/// sample times, and for samples that are missing.
[[nodiscard]] RecordedPair recorded_pair(RecordingFile const& file,
                                         std::array<ChosenColumn, 2> const& columns, double cycle_ms);

}  // namespace axisc
