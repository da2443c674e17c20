// Links, definitions, references: from file names to files, from parameters to the lines that set them.
#pragma once

#include "editor/capabilities/capability.hpp"

namespace axisc::editor {

/// The files that a machine file or a start-up list names.
[[nodiscard]] Json links(OpenMachines& machines, Json const& params);
/// The file that is named at the cursor, the list of the axis named there, or the lines that set a parameter
/// for the list.
[[nodiscard]] Json define(OpenMachines& machines, Json const& params);
/// The lines of the whole machine that set a parameter.
[[nodiscard]] Json refer(OpenMachines& machines, Json const& params);
/// Always throws RequestRefused, because names belong to the control: clients show the reason.
[[nodiscard]] Json refuse_renaming(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
