// Reasons why a machine cannot be compiled although no finding says so: none is shown, or only images are
// affected.
#pragma once

#include "axisc/environment/failure.hpp"
#include "diagnostics/message.hpp"
#include "validator/check.hpp"

#include <optional>
#include <string>

namespace axisc {

/// Failure if the NC cycle time is unknown: an image for a guessed one would shift every frequency.
void require_cycle_time(std::string const& input, validator::CheckResult const& result);

/// Why there is no machine although no finding shown says so: the input is an NC program, it has no axis,
/// files are missing, errors are hidden, or the machine would lack a configured filter.
[[nodiscard]] std::optional<Failure> refusal(std::string const& input, validator::CheckResult const& result,
                                             SourceSet const& sources, Language language);
/// Throws it.
void require_machine(std::string const& input, validator::CheckResult const& result, SourceSet const& sources,
                     Language language);

}  // namespace axisc
