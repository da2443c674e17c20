// From a name to where it is set, and from the name of a file to the file.
#pragma once

#include "editor/capabilities/capability.hpp"

namespace axisc::editor {

/// The files that a machine file or a start-up list names.
[[nodiscard]] Json links(OpenMachines& machines, Json const& params);
/// A file that the document names, the list of an axis, or the lines that decide a parameter for the list.
[[nodiscard]] Json define(OpenMachines& machines, Json const& params);
/// The lines of the whole machine that set a parameter.
[[nodiscard]] Json refer(OpenMachines& machines, Json const& params);
/// RequestRefused: names belong to the control. Clients show the reason.
[[nodiscard]] Json refuse_renaming(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
