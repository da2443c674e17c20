// Inlay hints: the quantity of a raw number, and the defaults that a filter uses.
#pragma once

#include "editor/capabilities/capability.hpp"

namespace axisc::editor {

[[nodiscard]] Json hints(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
