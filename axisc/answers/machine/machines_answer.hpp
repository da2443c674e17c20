// Which machines there are, and where each gets its NC cycle time from.
#pragma once

#include "axisc/workspace/workspace.hpp"
#include "presentation/document.hpp"

#include <string>

namespace axisc {

/// A row for each machine in a folder; for a file the one that it belongs to, which is the file itself where
/// no machine reads it. Machines without an axis are left out. `cycle_time_from` is the line or the file that
/// says the cycle time; none where an option of the caller does. Failure for an unreadable input.
[[nodiscard]] presentation::Document machines_answer(Workspace& workspace, std::string const& input);

}  // namespace axisc
