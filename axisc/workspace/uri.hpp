// File names in URIs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace axisc {

/// On Windows, the host of a URI is that of a share: `file://server/share/x.lis` is `//server/share/x.lis`.
/// Elsewhere hosts are ignored.
enum class FileNames : std::uint8_t { posix, windows };

inline constexpr auto own_file_names =
    std::filesystem::path::preferred_separator == '/' ? FileNames::posix : FileNames::windows;

/// The path of a `file:` URI, with `/` between its folders; any other URI unchanged.
[[nodiscard]] std::string path_of(std::string_view uri, FileNames names = own_file_names);
[[nodiscard]] std::string uri_of(std::string_view path, FileNames names = own_file_names);

}  // namespace axisc
