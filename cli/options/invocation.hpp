// What a command is called with.
#pragma once

#include "cli/options/command_description.hpp"
#include "cli/terminal/console.hpp"
#include "diagnostics/message.hpp"

#include <span>
#include <string>

namespace axisc::cli {

/// The arguments after the command's name, and the output streams. Every command may throw a Failure.
struct Invocation {
  std::span<std::string const> arguments;
  Language language = Language::english;
  Streams& streams;
  CommandDescription* description = nullptr;  ///< where there is one, it is filled in and nothing is executed
};

}  // namespace axisc::cli
