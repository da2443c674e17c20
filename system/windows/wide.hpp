// Text of Windows: UTF-16 there, UTF-8 here.
#pragma once

#include <string>
#include <string_view>

namespace axisc::system {

/// Bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::wstring wide(std::string_view text);
[[nodiscard]] std::string narrow(std::wstring_view text);
/// A path as the functions of Windows take it: absolute and without the limit of 260 characters where it is
/// long.
[[nodiscard]] std::wstring wide_path(std::string_view path);

}  // namespace axisc::system
