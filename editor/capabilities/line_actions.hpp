// Code actions that insert text in one line.
#pragma once

#include "diagnostics/finding.hpp"
#include "editor/reading/open_machines.hpp"

namespace axisc::editor {

/// Allow a finding on its line, and explain it. `shown` is its diagnostic.
void add_finding_actions(Json& actions, OpenMachines& machines, OpenDocument const& document,
                         Finding const& finding, Json const& shown);
/// For the line at a byte: name the number of an enumeration in a comment, and convert a value that has a
/// unit to the unit of the list.
void add_rewrites(Json& actions, OpenMachines& machines, OpenDocument const& document, std::size_t offset);

}  // namespace axisc::editor
