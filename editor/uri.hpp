// File names in URIs.
#pragma once

#include <string>
#include <string_view>

namespace axisc::editor {

/// The path of a `file:` URI, "//server/share/x.lis" where it names another computer; any other URI unchanged.
[[nodiscard]] std::string path_of(std::string_view uri);
[[nodiscard]] std::string uri_of(std::string_view path);

}  // namespace axisc::editor
