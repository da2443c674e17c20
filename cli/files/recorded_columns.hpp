// A scope's recording of an axis: the setpoint before the filters and behind them.
#pragma once

#include "design/units.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace axisc::cli {

struct WantedColumns {
  std::optional<std::string> input, output;  ///< names, or numbers from 1
};

struct RecordedColumns {
  std::string input_name, output_name;
  std::vector<double> input, output;  ///< a value a cycle
  std::vector<std::size_t> gaps;  ///< cycles that were lost and are interpolated, by the column of the time
  std::size_t repeated = 0;       ///< rows that were recorded twice and are left out
};

/// Columns are separated by tabs, semicolons or commas; whether a comma is a decimal comma is decided by the whole column.
/// Lines before the first line of numbers are headers, the last of them with as many fields names the columns; the line
/// EOF ends the recording. A column whose name begins with "time" or "zeit" is the time of the columns behind it, in ms
/// unless the name ends in "_s" or "[s]"; without names the first of three columns, and the first of each pair of four.
/// Failure (AX9005) for a mistake, AX9001 for a file that cannot be read.
[[nodiscard]] RecordedColumns read_recorded_columns(std::string const& path, WantedColumns const& wanted,
                                                    design::CycleTime cycle_time);

}  // namespace axisc::cli
