// The pages behind the codes: what `axisc explain` prints and docs/rules.md collects.
#pragma once

#include "diagnostics/finding.hpp"

#include <string_view>

namespace axisc {

/// Markdown without the heading; empty when there is no page. The pages stand in text/pages/<en|de>/AXNNNN.md
/// and are embedded when the program is built; a first line "# …" is left out. Cost: a binary search.
[[nodiscard]] std::string_view page(Code code, Language language);

}  // namespace axisc
