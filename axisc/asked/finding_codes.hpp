// Codes as users write them.
#pragma once

#include "diagnostics/finding.hpp"

#include <optional>
#include <string_view>

namespace axisc {

/// "AX3005", "ax3005" or "delay-too-long"; none for anything else.
[[nodiscard]] std::optional<Code> find_code(std::string_view word);

}  // namespace axisc
