// Options that `lint` and `compile` share: those of the check and the format of its findings.
#pragma once

#include "axisc/checking/checking_options.hpp"
#include "cli/options/command_line.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc::cli {

/// What lists and machine files do not say of their control.
void declare_control(CommandLine& command_line, CheckingOptions& options);
/// Those and all others.
void declare_checking(CommandLine& command_line, CheckingOptions& options);
/// `--alone`.
void declare_alone(CommandLine& command_line, bool& alone);
/// `--schema FILE`, which every command that reads lists has.
void declare_schema(CommandLine& command_line, std::vector<std::string>& files);

/// `-j N`, which every command that works on several inputs has.
void declare_threads(CommandLine& command_line, std::optional<std::string>& threads);

}  // namespace axisc::cli
