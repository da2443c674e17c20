// From the axes that a channel list or a machine file names to their lists.
#pragma once

#include "editor/reading/machine_reading.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace axisc::editor {

/// The list of the axis that is named at a byte of the document: by its number in a channel list, by its name
/// in the groups and gantries of a machine file.
[[nodiscard]] std::optional<std::string> list_of_named_axis(MachineReading const& reading,
                                                            OpenDocument const& document, std::size_t offset);

}  // namespace axisc::editor
