// Codes as users write them.
#pragma once

#include "diagnostics/finding.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace axisc {

/// "AX3005", "ax3005" or "delay-too-long"; none for anything else.
[[nodiscard]] std::optional<Code> find_code(std::string_view word);

/// The same, or all that begin so: "AX1*", "filter-*". Empty for anything else.
[[nodiscard]] std::vector<Code> find_codes(std::string_view word);

}  // namespace axisc
