// The machine of an input, for commands that compile it in memory and use the image.
#pragma once

#include "cli/checking/check_input.hpp"
#include "cli/commands/commands.hpp"
#include "validator/loading/loading.hpp"

#include <optional>
#include <string>

namespace axisc::cli {

/// Checks with the settings that apply to the input. If findings prevent a machine, those of severity error go to
/// standard error and none is returned; everything else that `compile` refuses is a Failure, except an unknown cycle
/// time. The machine of the result reads its NC programs from `files` again.
[[nodiscard]] std::optional<validator::CheckResult> check_machine(CheckJob const& job,
                                                                  std::string const& path,
                                                                  configuration::Files& files,
                                                                  Invocation const& invocation, bool color);
/// The same, and keeps what was read: the machine in `loaded` refers to `sources`.
[[nodiscard]] std::optional<validator::CheckResult> check_machine(
    CheckJob const& job, std::string const& path, configuration::Files& files, Invocation const& invocation,
    bool color, SourceSet& sources, std::optional<validator::LoadedMachine>& loaded);

}  // namespace axisc::cli
