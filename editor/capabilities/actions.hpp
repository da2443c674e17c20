// Code actions: fixes of findings, all safe fixes at once, and additions to the line at the cursor.
#pragma once

#include "editor/capabilities/capability.hpp"

namespace axisc::editor {

[[nodiscard]] Json code_actions(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
