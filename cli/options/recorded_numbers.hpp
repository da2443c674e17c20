// Options that say what the columns of a recording are.
#pragma once

#include "axisc/answers/execution/recorded_scale.hpp"
#include "cli/options/command_line.hpp"

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

}  // namespace axisc::cli
