// Options of `axisc compare`, for its two halves: filters, and the motion along a path.
#pragma once

#include "axisc/answers/comparison/recording_template.hpp"
#include "axisc/answers/execution/recorded_axis.hpp"
#include "cli/commands/commands.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/recorded_numbers.hpp"
#include "presentation/writers.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axisc::cli {

enum class Emitted : std::uint8_t { nothing, settings, program, scope_template };

struct CompareOptions {
  std::optional<std::string> input, recording, axis, cycle_time, program, group, output, net_id;
  std::vector<std::string> commands, columns;
  RecordedNumbers numbers;
  bool alone = false;
  presentation::Format format = presentation::Format::text;
  Emitted emitted = Emitted::nothing;
  RecordingPurpose purpose = RecordingPurpose::compare;
};

/// `--program`: which readings of `motion` the recording shows.
[[nodiscard]] ExitStatus compare_motion(CompareOptions const& options, Invocation const& invocation,
                                        CommandLine const& command_line);
/// `--emit program`: writes the program that tells them.
[[nodiscard]] ExitStatus emit_program(CompareOptions const& options, Invocation const& invocation,
                                      CommandLine const& command_line);

/// `--emit template`: writes the scope's configuration that records what a comparison needs.
[[nodiscard]] ExitStatus emit_template(CompareOptions const& options, Invocation const& invocation,
                                       CommandLine const& command_line);

/// `--emit settings`: only what is determined; what is left open is said, and is no success: what fits is
/// written in part. `nothing` is said where there are no settings.
[[nodiscard]] ExitStatus emit_settings(std::optional<std::string> const& settings,
                                       std::vector<Message> const& left_open, bool is_complete,
                                       SentenceRef nothing, Invocation const& invocation);

}  // namespace axisc::cli
