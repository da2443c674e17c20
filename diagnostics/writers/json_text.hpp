// JSON as the commands print it: no character that a terminal would obey or a reader would not see.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace axisc {

/// With quotes and escapes; invalid UTF-8 becomes U+FFFD.
[[nodiscard]] std::string json_string(std::string_view text);

/// A whole document, indented by two, with a line end.
[[nodiscard]] std::string json_document(nlohmann::ordered_json const& json);

}  // namespace axisc
