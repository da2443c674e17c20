// The layout of lists, as `fmt` writes it.
#pragma once

#include "editor/capabilities/capability.hpp"

namespace axisc::editor {

[[nodiscard]] Json format(OpenMachines& machines, Json const& params);
/// The lines of the range as they are in the aligned list: lines keep their numbers.
[[nodiscard]] Json format_range(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
