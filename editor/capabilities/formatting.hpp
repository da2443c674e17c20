// The layout of lists, as `fmt` writes it.
#pragma once

#include "editor/capabilities/capability.hpp"

namespace axisc::editor {

[[nodiscard]] Json format(OpenMachines& machines, Json const& params);
/// Takes the lines of the range from the aligned list. Formatting keeps line numbers.
[[nodiscard]] Json format_range(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
