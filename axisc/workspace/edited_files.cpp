#include "axisc/workspace/edited_files.hpp"

#include "validator/loading/loader.hpp"

#include <algorithm>

namespace axisc {

using configuration::FileError;

std::variant<std::string, FileError> EditedFiles::read(std::string const& path) {
  auto const found = find(path);
  if (found == edited_.end()) return disk_.read(path);
  return found->second;
}

std::optional<FileError> EditedFiles::read_pieces(std::string const& path,
                                                  configuration::PieceReceiver const& receive) {
  return find(path) != edited_.end() ? Files::read_pieces(path, receive) : disk_.read_pieces(path, receive);
}

bool EditedFiles::is_file(std::string const& path) {
  return find(path) != edited_.end() || disk_.is_file(path);
}

std::vector<std::string> EditedFiles::names_in(std::string const& folder) {
  auto names = disk_.names_in(folder);
  for (auto const& [path, bytes] : edited_) {
    if (!path.starts_with(folder) || path.find('/', folder.size()) != std::string::npos) continue;
    auto name = path.substr(folder.size());
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  }
  return names;
}

bool EditedFiles::is_same(std::string const& one, std::string const& other) {
  return one == other || disk_.is_same(one, other);
}

EditedBytes::const_iterator EditedFiles::find(std::string const& path) const {
  auto const found = edited_.find(path);
  if (found != edited_.end() || edited_.empty()) return found;
  auto const normal = edited_.find(validator::key_of(path));
  if (normal != edited_.end()) return normal;
  // From a folder above, or through a link to one of its folders.
  auto const name = validator::file_name(path);
  return std::find_if(edited_.begin(), edited_.end(), [&](auto const& known) {
    return validator::file_name(known.first) == name && disk_.is_same(known.first, path);
  });
}

}  // namespace axisc
