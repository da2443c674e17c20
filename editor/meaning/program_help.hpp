// The #FILTER commands of NC programs, for who writes them.
#pragma once

#include "diagnostics/sentence.hpp"
#include "validator/loading/loading.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::editor {

struct CommandHelp {
  std::string text;  ///< Markdown that can be read as it is
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// What the command at a byte puts in force, with the kernel of each axis of the machine; none where there is no command, or
/// one that depends on variables or is wrong. Loops and calls are not followed: commands count as they stand.
[[nodiscard]] std::optional<CommandHelp> command_help(std::string_view text, std::size_t offset,
                                                      validator::LoadedMachine const* machine,
                                                      Language language);

/// What may follow the text of a line up to the cursor: commands, switches, keywords.
[[nodiscard]] std::vector<std::string> command_words(std::string_view typed);

}  // namespace axisc::editor
