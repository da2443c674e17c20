// What keeps a machine from being compiled though no finding says so: it was silenced, or only an image needs it.
#pragma once

#include "diagnostics/message.hpp"
#include "validator/check.hpp"

#include <string>

namespace axisc::cli {

/// Failure where the NC cycle time had to be assumed: an image for a guessed one would move every frequency.
void require_cycle_time(std::string const& input, validator::CheckResult const& result);

/// For a result whose findings let the input pass. Failure where it has no machine all the same (an NC program, a machine
/// file whose mistakes are silenced), and where the machine would lack a filter that is configured.
void require_machine(std::string const& input, validator::CheckResult const& result, SourceSet const& sources,
                     Language language);

}  // namespace axisc::cli
