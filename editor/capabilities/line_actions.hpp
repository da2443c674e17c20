// Actions that insert something in a single line of a document.
#pragma once

#include "diagnostics/finding.hpp"
#include "editor/reading/open_machines.hpp"

namespace axisc::editor {

/// Allowing a finding on its line, and its page. `shown` is its diagnostic.
void add_finding_actions(Json& actions, OpenMachines& machines, Document const& document,
                         Finding const& finding, Json const& shown);
/// For the line at a byte: the word of a number of an enumeration as a comment, and the number in the unit of the list
/// for a value that was written with another unit.
void add_rewrites(Json& actions, OpenMachines& machines, Document const& document, std::size_t offset);

}  // namespace axisc::editor
