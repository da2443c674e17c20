#pragma once

#include <string>
#include <string_view>

namespace axisc {

/// "0.2.0"
[[nodiscard]] std::string_view program_version();

/// "axisc 0.2.0 (commit 0123456789ab, GCC 12.2.0; …)" with a line end.
[[nodiscard]] std::string version_text();

}  // namespace axisc
