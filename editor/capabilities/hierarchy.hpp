// From a parameter to everything that sets it: the values that it overrides, and those that override it.
#pragma once

#include "editor/capabilities/capability.hpp"

namespace axisc::editor {

[[nodiscard]] Json prepare_hierarchy(OpenMachines& machines, Json const& params);
[[nodiscard]] Json supertypes(OpenMachines& machines, Json const& params);
[[nodiscard]] Json subtypes(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
