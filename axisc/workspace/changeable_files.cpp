#include "axisc/workspace/changeable_files.hpp"

#include "axisc/workspace/machine_outline.hpp"
#include "system/path.hpp"

#include <filesystem>

namespace axisc {

namespace {

namespace fs = std::filesystem;

/// As far as it exists: unsaved text may have no file.
fs::path resolved(std::string const& name) {
  std::error_code error;
  auto const found = fs::weakly_canonical(fs::absolute(system::path_of(name), error), error);
  return error ? fs::path() : found;
}

}  // namespace

ChangeableFiles::ChangeableFiles(std::vector<std::string> const& named) {
  for (auto const& name : named) {
    auto const path = resolved(name);
    std::error_code error;
    (fs::is_directory(path, error) ? folders_ : files_).insert(system::name_of(path));
    if (!outline_of(name).is_machine) continue;
    auto const folder = system::name_of(system::path_of(name).parent_path());
    folders_.insert(system::name_of(resolved(folder.empty() ? "." : folder)));
  }
}

bool ChangeableFiles::contains(std::string const& path) const {
  auto const file = resolved(path);
  if (file.empty()) return false;
  if (files_.contains(system::name_of(file))) return true;
  for (auto folder = file.parent_path();; folder = folder.parent_path()) {
    if (folders_.contains(system::name_of(folder))) return true;
    if (folder == folder.parent_path()) return false;
  }
}

}  // namespace axisc
