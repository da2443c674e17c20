// `--at CYCLE:COMMAND`: #FILTER commands that `run` and `response` execute.
#pragma once

#include "cli/files/image_file.hpp"
#include "image/runtime_host.hpp"
#include "machine/filter_command.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace axisc::cli {

struct TimedCommand {
  std::uint64_t cycle = 0;
  std::string text;  ///< the command as it was written
  machine::FilterCommand command;
};

/// The commands by rising cycle, those of one cycle in the order of the command line. Failure for words that are no
/// CYCLE:COMMAND, for a command that is not right, and where nothing in the image could be switched.
[[nodiscard]] std::vector<TimedCommand> read_timed_commands(std::vector<std::string> const& words,
                                                            ImageFile const& file, std::string const& path,
                                                            Language language);

/// Executes the command in every channel that has kernels for it. Failure, naming the banks, where none has; and where a
/// filter is still changing over or the axes would have to stand.
void execute(TimedCommand const& command, image::RuntimeHost& host, image::ImageContents const& image,
             std::string const& path);

}  // namespace axisc::cli
