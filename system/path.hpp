// Names of files: UTF-8 with `/` in the whole program, in the system's form inside std::filesystem.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace axisc::system {

/// The path of this name. The constructor of std::filesystem::path does not take UTF-8 everywhere.
[[nodiscard]] std::filesystem::path path_of(std::string_view name);
/// The name of this path, with `/` between its folders.
[[nodiscard]] std::string name_of(std::filesystem::path const& path);
/// The name with all links resolved, absolute; nothing where no file has it.
[[nodiscard]] std::optional<std::string> real_name(std::string const& name);

}  // namespace axisc::system
