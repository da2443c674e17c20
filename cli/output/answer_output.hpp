// Prints answers in the format that the user wants. Every command that answers a question has the same
// formats.
#pragma once

#include "cli/options/command_line.hpp"
#include "cli/options/invocation.hpp"
#include "presentation/writers.hpp"

namespace axisc::cli {

/// `--format` with every format that answers have. The value before is the default.
void declare_format(CommandLine& command_line, presentation::Format& format);

void print(presentation::Document const& answer, presentation::Format format, Invocation const& invocation,
           CommandLine const& command_line);

}  // namespace axisc::cli
