// How `axisc machine` shows what an input says about the machine.
#pragma once

#include "diagnostics/message.hpp"
#include "validator/loading/loading.hpp"

#include <string>

namespace axisc {

/// Axes, channels and cycle time, and where each was read.
[[nodiscard]] std::string machine_text(validator::LoadedMachine const& machine, SourceSet const& sources,
                                       Language language);

/// What the machine lacks, a line each: files that are missing, cannot be read or are of another kind.
[[nodiscard]] std::string machine_lacks(validator::LoadedMachine const& machine, SourceSet const& sources,
                                        Language language);

/// The same as a machine file whose paths count from the working folder.
[[nodiscard]] std::string machine_json(validator::LoadedMachine const& machine, SourceSet const& sources);

}  // namespace axisc
