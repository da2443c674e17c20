// Patterns for paths, as .gitignore users know them.
#pragma once

#include <string_view>

namespace axisc {

/// `?` is one character and `*` any number of them, neither a slash; `**` is anything, and `**/` also nothing
/// at all.
[[nodiscard]] bool matches_glob(std::string_view pattern, std::string_view path);

}  // namespace axisc
