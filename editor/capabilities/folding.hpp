// Comments, and the lines that they head, as ranges that an editor can fold.
#pragma once

#include "editor/capabilities/capability.hpp"

namespace axisc::editor {

/// A comment heads the lines after it, up to the next comment after a blank line; a comment of several lines folds by itself.
[[nodiscard]] Json fold(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
