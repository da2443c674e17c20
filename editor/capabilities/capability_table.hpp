// The capabilities of the server by the names of the protocol.
#pragma once

#include "editor/capabilities/capability.hpp"

#include <string_view>

namespace axisc::editor {

/// Null for a method that is not one of open documents.
[[nodiscard]] Capability find_capability(std::string_view method);
/// As a client is told of them.
[[nodiscard]] Json announced_capabilities();

}  // namespace axisc::editor
