#include "axisc/workspace/asked_files.hpp"

#include "validator/loading/loader.hpp"

#include <string_view>

namespace axisc {

namespace {

std::string name_of(std::string const& path) {
  return std::string(validator::file_name(path));
}

std::string folder_part(std::string const& path) {
  return path.substr(0, path.size() - validator::file_name(path).size());
}

}  // namespace

void AskedFiles::add(std::string const& path) {
  names.insert(name_of(path));
}

void AskedFiles::add_folder(std::string const& path) {
  auto folder = validator::key_of(path);
  if (!folder.ends_with('/')) folder += '/';
  folders.insert(std::move(folder));
}

void Readers::add(std::string const& machine, AskedFiles const& asked) {
  for (auto const& name : asked.names) names_[name].insert(machine);
  for (auto const& folder : asked.folders) folders_[folder].insert(machine);
}

void Readers::clear() {
  names_.clear();
  folders_.clear();
}

bool Readers::know(std::string const& path) const {
  auto const other = [&path](std::map<std::string, Machines> const& readers, std::string const& wanted) {
    auto const found = readers.find(wanted);
    return found != readers.end() && (found->second.size() > 1 || !found->second.contains(path));
  };
  return other(names_, name_of(path)) || other(folders_, folder_part(path));
}

}  // namespace axisc
