// What several requests read from their parameters.
#pragma once

#include "editor/reading/text_positions.hpp"

#include <nlohmann/json_fwd.hpp>

namespace axisc::editor {

/// A position that a client names. A Json exception where it is none: also negative and broken numbers.
[[nodiscard]] TextPosition position_in(nlohmann::json const& json);

}  // namespace axisc::editor
