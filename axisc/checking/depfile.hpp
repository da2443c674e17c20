// Dependency files for make and ninja.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace axisc {

/// "target: source source" with a line end; blanks, '#', '$' and ':' in names are escaped as make demands.
/// Standard input ("-") is not a file and is left out.
[[nodiscard]] std::string dependency_rule(std::string_view target, std::vector<std::string> const& sources);

}  // namespace axisc
