// Pieces of JSON for output that is written row by row.
#pragma once

#include <string>
#include <string_view>

namespace axisc::cli {

/// With quotes and escapes; invalid UTF-8 becomes U+FFFD.
[[nodiscard]] std::string json_string(std::string_view text);

/// Reads back as the same double; `null` for NaN and infinities, which JSON lacks.
[[nodiscard]] std::string json_number(double value);

}  // namespace axisc::cli
