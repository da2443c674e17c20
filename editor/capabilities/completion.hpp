// Completion of names, values and references in lists, and of commands in programs.
#pragma once

#include "editor/capabilities/capability.hpp"

namespace axisc::editor {

[[nodiscard]] Json complete(OpenMachines& machines, Json const& params);
/// Adds the page that a hover shows. Items that are not parameters are returned unchanged.
[[nodiscard]] Json resolve_completion(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
