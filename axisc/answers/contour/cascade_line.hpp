// The line above a cascade of filters in an editor.
#pragma once

#include "axisc/workspace/workspace.hpp"
#include "diagnostics/message.hpp"

#include <optional>
#include <string>

namespace axisc {

/// "delay 12.4 ms, 0.35 mm at a corner at 60000 mm/min" for the axis of the machine, or for each axis if none
/// is named; or the reason why there are no figures. Failure for a machine that cannot be read, and for an
/// unknown NC cycle time.
[[nodiscard]] std::string cascade_line(Workspace& workspace, std::string const& path,
                                       std::optional<std::string> const& axis, Language language);

}  // namespace axisc
