// The meaning of what the user points at: a name, a value, the number of a parameter, a command of a program.
#pragma once

#include "editor/capabilities/capability.hpp"

namespace axisc::editor {

/// The page of the parameter as `explain` prints it, with the value in effect and the figures of its filter.
[[nodiscard]] Json hover(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
