// A scope's recording of an axis: the setpoint before and after the filters.
#pragma once

#include "analysis/comparison/verdict.hpp"
#include "analysis/recordings/text_lines.hpp"
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
  comparison::Recording recording;  ///< lost cycles, by the column of the time, are interpolated
  std::size_t repeated = 0;         ///< rows that were recorded twice and are left out
};

/// Rows as in recorded_signals.hpp; without names the only two columns that are no time. `name` is the file
/// in messages. Failure (AX9005) for a mistake.
[[nodiscard]] RecordedColumns read_recorded_columns(std::string const& name, recordings::ByteSource source,
                                                    WantedColumns const& wanted,
                                                    design::CycleTime cycle_time);

}  // namespace axisc
