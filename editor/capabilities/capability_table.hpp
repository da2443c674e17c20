// The capabilities of the server by the names of the protocol.
#pragma once

#include "editor/capabilities/capability.hpp"

#include <string_view>

namespace axisc::editor {

/// Null for other methods.
[[nodiscard]] Capability find_capability(std::string_view method);
/// The answer to `initialize`, as far as it concerns them.
[[nodiscard]] Json announced_capabilities();

}  // namespace axisc::editor
