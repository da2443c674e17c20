// Reasons why a machine cannot be compiled although no finding says so: the finding was silenced, or only images are
// affected.
#pragma once

#include "diagnostics/message.hpp"
#include "validator/check.hpp"

#include <string>

namespace axisc::cli {

/// Failure if the NC cycle time is unknown: an image for a guessed one would shift every frequency.
void require_cycle_time(std::string const& input, validator::CheckResult const& result);

/// For a result whose findings let the input pass. Failure if it has no machine nevertheless (an NC program, a machine
/// file whose mistakes are silenced), and if the machine would lack a configured filter.
void require_machine(std::string const& input, validator::CheckResult const& result, SourceSet const& sources,
                     Language language);

}  // namespace axisc::cli
