// Sources as they are in an FMU: for compilers of others, and small.
#pragma once

#include <string>
#include <string_view>

namespace axisc::image {

/// A C source without its comments, apart from the one at its beginning, which says what the file is. Expects
/// comments between /* and */ only.
[[nodiscard]] std::string compact_source(std::string_view source);

}  // namespace axisc::image
