// Symbols: the outline of a list, and the axes and channels of all open machines.
#pragma once

#include "editor/capabilities/capability.hpp"

namespace axisc::editor {

[[nodiscard]] Json symbols(OpenMachines& machines, Json const& params);
[[nodiscard]] Json workspace_symbols(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
