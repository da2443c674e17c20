// How commands that take many files read their names, and what they say of files that they pass over.
#pragma once

#include "cli/options/command_line.hpp"
#include "diagnostics/message.hpp"

#include <string>
#include <vector>

namespace axisc::cli {

/// `--hook`.
void declare_hook(CommandLine& command_line, bool& hook);

/// "axisc: note: …", a line for each.
[[nodiscard]] std::string note_lines(std::vector<Message> const& notes, Language language);

}  // namespace axisc::cli
