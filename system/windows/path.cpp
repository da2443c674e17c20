#include "system/path.hpp"

#include "system/windows/wide.hpp"

namespace axisc::system {

std::filesystem::path path_of(std::string_view name) {
  return wide(name);
}

std::string name_of(std::filesystem::path const& path) {
  return narrow(path.generic_wstring());
}

std::optional<std::string> real_name(std::string const& name) {
  std::error_code error;
  auto const found = std::filesystem::canonical(path_of(name), error);
  return error ? std::nullopt : std::optional(name_of(found));
}

}  // namespace axisc::system
