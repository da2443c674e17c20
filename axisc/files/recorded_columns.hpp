// A scope's recording of an axis: the setpoint before and after the filters.
#pragma once

#include "analysis/comparison/verdict.hpp"
#include "axisc/files/recorded_choice.hpp"
#include "axisc/files/recording_file.hpp"
#include "design/units.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace axisc {

struct WantedColumns {
  std::optional<std::string> input, output;  ///< names, or numbers from 1
};

struct RecordedColumns {
  std::string input_name, output_name;
  ChosenColumn input, output;
  comparison::Recording recording;  ///< lost cycles, by the times, are interpolated
  std::size_t repeated = 0;         ///< rows that were recorded twice and are left out
};

/// Columns as in recorded_choice.hpp, in the units of the file. Failure (AX9005) for a mistake.
[[nodiscard]] RecordedColumns read_recorded_columns(RecordingFile const& file, AxisPlace const& axis,
                                                    WantedColumns const& wanted,
                                                    design::CycleTime cycle_time);

}  // namespace axisc
