// How deep a JSON text is nested, before anything that recurses reads it.
#pragma once

#include <cstddef>
#include <string_view>

namespace axisc::configuration {

/// The most brackets that are open at once, as far as the text is JSON. Cost: one pass.
[[nodiscard]] std::size_t json_nesting(std::string_view json);

}  // namespace axisc::configuration
