// All commands of the program, in the order in which its help names them.
#pragma once

#include "cli/commands/commands.hpp"

#include <span>
#include <string_view>

namespace axisc::cli {

struct CommandRow {
  std::string_view name;
  SentenceRef meaning;
  ExitStatus (*run)(Invocation const&);
};

[[nodiscard]] std::span<CommandRow const> commands();

/// The program without a command; it has no name.
[[nodiscard]] CommandDescription program_description();
[[nodiscard]] CommandDescription description_of(CommandRow const& command);

}  // namespace axisc::cli
