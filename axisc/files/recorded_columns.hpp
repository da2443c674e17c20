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

/// Rows as in analysis/recordings/number_rows.hpp. A column whose name begins with "time" or "zeit" is the
/// time of the columns after it, in ms unless the name ends in "_s" or "[s]"; without names the first of
/// three columns, and the first of each pair of four. `name` is the file in messages. Failure (AX9005) for a
/// mistake, also where more than a quarter of the cycles is lost.
[[nodiscard]] RecordedColumns read_recorded_columns(std::string const& name, recordings::ByteSource source,
                                                    WantedColumns const& wanted,
                                                    design::CycleTime cycle_time);

}  // namespace axisc
