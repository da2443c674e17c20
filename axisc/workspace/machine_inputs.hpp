// The machines that an input names.
#pragma once

#include <string>
#include <vector>

namespace axisc {

/// The machines in a folder, sorted: machine files, projects, and start-up lists of which no machine file
/// names a list. For a file, and for "-", the input itself. Failure for a folder that cannot be read. Folders
/// are searched on the disk alone.
[[nodiscard]] std::vector<std::string> machine_inputs(std::string const& name);

}  // namespace axisc
