// The axis of an input that a scope recorded, beside its recording.
#pragma once

#include "axisc/answers/execution/recorded_axis.hpp"
#include "axisc/checking/compiled_input.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc {

struct RecordedQuestion {
  std::string input, recording;       ///< paths
  std::optional<std::string> axis;    ///< none: that of the list, or the one that recorded_axis() finds
  std::vector<std::string> commands;  ///< CYCLE:COMMAND, executed before that cycle of the recording
  WantedColumns columns = {};
  PositionUnits units = {};
  Language language = Language::english;  ///< of commands quoted in a Failure
};

struct RecordedInput {
  std::size_t axis = 0;
  RecordedAxis recorded;
};

/// `input` is that of the question, compiled; the recording is read from the disk. Failures as those of
/// compare_axis(), and for commands after the end of the recording.
[[nodiscard]] RecordedInput recorded_input(RecordedQuestion const& question, InputImage const& input);

}  // namespace axisc
