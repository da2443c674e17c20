// The values of a command's keywords.
#pragma once

#include "validator/commands/command_check.hpp"

#include <optional>
#include <string_view>

namespace axisc::validator {

/// The number of an integer or real token. A value too large for a double is infinite, and so out of every
/// range.
[[nodiscard]] double number_of(std::string_view token);

/// The value of a keyword that the command has; its mistakes are added to `checked`. None if it cannot be
/// used.
[[nodiscard]] std::optional<double> checked_value(grammar::NcCommand const& command,
                                                  grammar::Keyword const& keyword, std::string_view text,
                                                  CommandLimits const& limits, Variables variables,
                                                  CheckedCommand& checked);

}  // namespace axisc::validator
