#include "diagnostics/repository_path.hpp"

#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {
namespace {

bool may_stand_in_uri(char character) {
  return ascii::is_letter(character) || ascii::is_digit(character) ||
         std::string_view("-._~/").find(character) != std::string_view::npos;
}

/// Appends the names of a path to `names`, resolving "." and "..".
void add_names(std::string_view path, std::vector<std::string_view>& names) {
  while (!path.empty()) {
    std::size_t const end = std::min(path.find('/'), path.size());
    std::string_view const name = path.substr(0, end);
    path.remove_prefix(std::min(end + 1, path.size()));
    if (name.empty() || name == ".") continue;
    if (name != "..") {
      names.push_back(name);
    } else if (!names.empty()) {
      names.pop_back();
    }
  }
}

}  // namespace

std::optional<std::string> path_in_repository(RepositoryPaths const& paths, std::string_view file) {
  if (file == "-" || file.empty() || paths.root.empty()) return std::nullopt;
  std::vector<std::string_view> whole;
  if (!file.starts_with('/')) add_names(paths.folder, whole);
  add_names(file, whole);
  std::vector<std::string_view> root;
  add_names(paths.root, root);
  if (whole.size() < root.size() || !std::equal(root.begin(), root.end(), whole.begin())) return std::nullopt;
  if (whole.size() == root.size()) return ".";
  std::string relative;
  for (std::string_view const name : std::span(whole).subspan(root.size())) {
    if (!relative.empty()) relative += '/';
    relative += name;
  }
  return relative;
}

std::string shown_path(RepositoryPaths const& paths, std::string_view file) {
  return path_in_repository(paths, file).value_or(std::string(file));
}

std::string as_uri(std::string_view path) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string uri;
  for (char const character : path) {
    if (may_stand_in_uri(character)) {
      uri += character;
      continue;
    }
    auto const byte = static_cast<unsigned char>(character);
    uri += '%';
    uri += digits[byte >> 4U];
    uri += digits[byte & 0xFU];
  }
  return uri;
}

}  // namespace axisc
