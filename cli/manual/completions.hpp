// What shells offer after `axisc `: commands, options, the values of options that have no others, names of
// files.
#pragma once

#include "cli/options/command_description.hpp"

#include <span>
#include <string>

namespace axisc::cli {

[[nodiscard]] std::string bash_completion(CommandDescription const& program,
                                          std::span<CommandDescription const> commands);
[[nodiscard]] std::string zsh_completion(CommandDescription const& program,
                                         std::span<CommandDescription const> commands);
[[nodiscard]] std::string fish_completion(CommandDescription const& program,
                                          std::span<CommandDescription const> commands);

}  // namespace axisc::cli
