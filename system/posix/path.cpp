#include "system/path.hpp"

#include <cstdlib>
#include <memory>

namespace axisc::system {

std::filesystem::path path_of(std::string_view name) {
  return name;
}

std::string name_of(std::filesystem::path const& path) {
  return path.string();
}

std::optional<std::string> real_name(std::string const& name) {
  std::unique_ptr<char, decltype(&std::free)> const found(::realpath(name.c_str(), nullptr), std::free);
  return found ? std::optional<std::string>(found.get()) : std::nullopt;
}

}  // namespace axisc::system
