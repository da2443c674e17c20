// Completion of names, values and references in lists, and of commands in programs.
#pragma once

#include "editor/capabilities/capability.hpp"

namespace axisc::editor {

[[nodiscard]] Json complete(OpenMachines& machines, Json const& params);
/// The item with the page that a hover shows; an item without a parameter is complete already.
[[nodiscard]] Json resolve_completion(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
