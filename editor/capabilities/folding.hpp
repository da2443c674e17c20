// Folding ranges: comments, and the lines below them.
#pragma once

#include "editor/capabilities/capability.hpp"

namespace axisc::editor {

/// A comment is the heading of the lines after it, up to the next comment that follows a blank line. Comments
/// of several lines can be folded, too.
[[nodiscard]] Json fold(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
