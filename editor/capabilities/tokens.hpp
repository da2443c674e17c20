// Semantic tokens of a list: names, indices, values, comments, and what the control ignores.
#pragma once

#include "editor/capabilities/capability.hpp"

namespace axisc::editor {

/// The meaning of the numbers in tokens.
[[nodiscard]] Json token_legend();
[[nodiscard]] Json tokens(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
