// The machine of an input, for commands that compile it in memory and use the image.
#pragma once

#include "axisc/checking/check_input.hpp"
#include "validator/loading/loading.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

/// Takes the findings of severity error that prevent a machine.
struct ErrorSink {
  Language language = Language::english;  ///< of texts quoted in a Failure
  std::function<void(std::vector<Finding> const&, SourceSet const&)> take;
};

/// Reads a machine with the settings that apply to it, unchecked. Failure where it cannot be read.
[[nodiscard]] validator::LoadedMachine loaded_machine(Workspace& workspace, std::string const& path,
                                                      SourceSet& sources);

/// Checks with the settings that apply to the input. If findings prevent a machine, `errors` takes them and
/// none is returned; everything else that `compile` refuses is a Failure, except an unknown cycle time. The
/// machine of the result reads its NC programs again.
[[nodiscard]] std::optional<validator::CheckResult> check_machine(Workspace& workspace,
                                                                  std::string const& path,
                                                                  ErrorSink const& errors);
/// Also keeps what was read: the machine in `loaded` refers to `sources`.
[[nodiscard]] std::optional<validator::CheckResult> check_machine(
    Workspace& workspace, std::string const& path, ErrorSink const& errors, SourceSet& sources,
    std::optional<validator::LoadedMachine>& loaded);

}  // namespace axisc
