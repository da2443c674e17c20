// Paths of Windows beyond 260 characters.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace axisc::system {

/// Files may have 260 characters with the zero, folders 12 less, so that an 8.3 file name fits into each.
inline constexpr std::size_t longest_plain_path = 248;

/// The form of an absolute path that has no limit: `\\?\C:\lists\x.lis` of `C:/lists/x.lis`,
/// `\\?\UNC\server\share\x.lis` of `//server/share/x.lis`. Paths in this form and names of devices are
/// unchanged.
[[nodiscard]] inline std::string extended_path(std::string_view absolute) {
  std::string path(absolute);
  std::replace(path.begin(), path.end(), '/', '\\');
  if (path.starts_with(R"(\\?\)") || path.starts_with(R"(\\.\)")) return path;
  if (path.starts_with(R"(\\)")) return R"(\\?\UNC)" + path.substr(1);
  return R"(\\?\)" + path;
}

}  // namespace axisc::system
