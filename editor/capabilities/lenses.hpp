// The line above each cascade of filters, and the commands that show pages.
#pragma once

#include "editor/capabilities/capability.hpp"

namespace axisc::editor {

/// Their text is computed when they are shown.
[[nodiscard]] Json lenses(OpenMachines& machines, Json const& params);
[[nodiscard]] Json resolve_lens(OpenMachines& machines, Json const& params);
/// A page: its title, its HTML, and the digests of its scripts.
[[nodiscard]] Json execute(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
