// Commands that look like #FILTER or #VIB GUARD and are neither.
#pragma once

#include "validator/commands/command_check.hpp"

#include <string_view>

namespace axisc::validator {

/// A mistake where another command was probably meant to be one of these two: one slip of the pen, blanks and
/// underscores aside.
void check_resembling(grammar::NcCommand const& command, std::string_view text, CheckedCommand& checked);

}  // namespace axisc::validator
