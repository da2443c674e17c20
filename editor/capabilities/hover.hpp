// Hovers: the meaning of a name, a value, the number of a parameter, or a command of an NC program.
#pragma once

#include "editor/capabilities/capability.hpp"

namespace axisc::editor {

/// The page of the parameter as `explain` prints it, with the value in effect and the figures of its filter.
[[nodiscard]] Json hover(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
