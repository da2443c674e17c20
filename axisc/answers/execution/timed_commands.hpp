// `--at CYCLE:COMMAND`: #FILTER commands that `run` and `response` execute, and that a control executed in a
// recording.
#pragma once

#include "axisc/files/image_file.hpp"
#include "configuration/machine/filter_command.hpp"
#include "image/runtime_host.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace axisc {

struct TimedCommand {
  std::uint64_t cycle = 0;
  std::string text;  ///< the command as it was written
  machine::FilterCommand command;
  machine::FilterParameters parameters;  ///< in force after it
};

/// The commands by rising cycle, those of one cycle in the order of the command line. Failure for a value
/// that is not CYCLE:COMMAND, for an invalid command, and if nothing in the image can be switched.
[[nodiscard]] std::vector<TimedCommand> read_timed_commands(std::vector<std::string> const& words,
                                                            ImageFile const& file, std::string const& path,
                                                            Language language);

/// Failure if one of them belongs to a cycle that a run of `cycles` does not have.
void refuse_late(std::vector<TimedCommand> const& commands, std::uint64_t cycles);

/// Executes the command in every channel that has kernels for it. Failure if no channel has them (the message
/// names the banks), if a filter is still changing over, or if the change is possible only at standstill.
void execute(TimedCommand const& command, image::RuntimeHost& host, image::ImageContents const& image,
             std::string const& path);

/// The kernels of the channel for what the command asks for, unless it is OFF. Failure if there are none: as
/// execute().
[[nodiscard]] image::ImageBank const& bank_of(TimedCommand const& command, image::ImageGroup const& group,
                                              image::ImageContents const& image, std::string const& path);

}  // namespace axisc
