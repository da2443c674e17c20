// The hierarchy of values: the lines that a line overrides, and the lines that override it.
#pragma once

#include "editor/capabilities/capability.hpp"

namespace axisc::editor {

[[nodiscard]] Json prepare_hierarchy(OpenMachines& machines, Json const& params);
[[nodiscard]] Json supertypes(OpenMachines& machines, Json const& params);
[[nodiscard]] Json subtypes(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
