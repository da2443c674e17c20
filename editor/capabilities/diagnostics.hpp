// Findings as the protocol shows them.
#pragma once

#include "diagnostics/finding.hpp"
#include "editor/capabilities/capability.hpp"
#include "editor/reading/open_machines.hpp"
#include "editor/reading/places.hpp"

namespace axisc::editor {

[[nodiscard]] Json diagnostic(Finding const& finding, Places const& places, Client const& client);
/// The findings of the document's machine that lie in the document.
[[nodiscard]] Json diagnostics(OpenMachines& machines, OpenDocument const& document);
/// For clients that pull diagnostics.
[[nodiscard]] Json pull(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
