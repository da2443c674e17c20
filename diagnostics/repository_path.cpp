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

constexpr std::size_t drive_size = 2;

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

bool begins_with_drive(std::string_view path) {
  return path.size() >= drive_size && ascii::is_letter(path[0]) && path[1] == ':';
}

std::optional<std::string> path_in_repository(RepositoryPaths const& paths, std::string_view file) {
  if (file == "-" || file.empty() || paths.root.empty()) return std::nullopt;
  bool const has_drives = begins_with_drive(paths.root);
  std::vector<std::string_view> whole;
  if (has_drives && file.starts_with('/') && !file.starts_with("//")) {
    add_names(std::string_view(paths.folder).substr(0, drive_size), whole);
  } else if (!file.starts_with('/') && !(has_drives && begins_with_drive(file))) {
    add_names(paths.folder, whole);
  }
  add_names(file, whole);
  std::vector<std::string_view> root;
  add_names(paths.root, root);
  auto const is_same = [has_drives](std::string_view one, std::string_view other) {
    return has_drives ? ascii::equal_ignoring_case(one, other) : one == other;
  };
  bool const is_below =
      whole.size() >= root.size() && std::equal(root.begin(), root.end(), whole.begin(), is_same);
  if (!is_below) return std::nullopt;
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
