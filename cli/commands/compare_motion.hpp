// `axisc compare` for the motion along a path: a program beside its recording, and the program to record.
#pragma once

#include "axisc/answers/comparison/motion_recording.hpp"
#include "cli/commands/commands.hpp"
#include "cli/options/command_line.hpp"
#include "presentation/writers.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc::cli {

struct MotionOptions {
  std::string input, recording, program;
  std::optional<std::string> group, cycle_time;
  std::vector<std::string> columns;  ///< of `--in`
  RecordedUnit unit = RecordedUnit::recognised;
  bool alone = false;
  bool emits_settings = false;
  presentation::Format format = presentation::Format::text;
};

/// `--program`: which readings of `motion` the recording shows.
[[nodiscard]] ExitStatus compare_motion(MotionOptions const& options, Invocation const& invocation,
                                        CommandLine const& command_line);
/// `--emit program`: writes the program that tells them.
[[nodiscard]] ExitStatus emit_program(MotionOptions const& options, Invocation const& invocation,
                                      CommandLine const& command_line);

}  // namespace axisc::cli
