// From the mistakes of a command to findings.
#pragma once

#include "validator/engine/rule.hpp"

namespace axisc::validator {

/// Reports the command's mistakes of one code.
void report_mistakes(CommandContext const& context, Code code, Report& report);

}  // namespace axisc::validator
