// Symbols: the outline of a list; the axes and channels of all open machines, and the lines that set a
// parameter, which is found as `axisc explain` finds it: "Kv", "Kerbfilter".
#pragma once

#include "editor/capabilities/capability.hpp"

namespace axisc::editor {

[[nodiscard]] Json symbols(OpenMachines& machines, Json const& params);
[[nodiscard]] Json workspace_symbols(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
