// Options that say what the columns of a recording are.
#pragma once

#include "axisc/answers/execution/recorded_scale.hpp"
#include "axisc/files/recorded_positions.hpp"
#include "cli/options/command_line.hpp"

#include <string>
#include <vector>

namespace axisc::cli {

/// --unit, --scaled, --raw as given.
struct RecordedNumbers {
  RecordedUnit unit = RecordedUnit::recognised;
  bool scaled = false, raw = false;

  /// Failure for both --scaled and --raw.
  [[nodiscard]] PositionUnits units() const;
};

/// `numbers` must outlive the command line's answers.
void declare_recorded_numbers(CommandLine& command_line, RecordedNumbers& numbers);

/// "X=COLUMN" each. Failure for other texts.
[[nodiscard]] std::vector<AxisColumn> axis_columns(std::string const& option,
                                                   std::vector<std::string> const& texts);

}  // namespace axisc::cli
