#include "system/folder.hpp"

#include "system/posix/error.hpp"

#include <algorithm>
#include <cerrno>
#include <dirent.h>
#include <memory>

namespace axisc::system {
namespace {

struct FolderCloser {
  void operator()(DIR* folder) const { ::closedir(folder); }
};

/// Some file systems do not report the kind of an entry.
FileKind kind_in(std::string const& folder, dirent const& entry) {
  switch (entry.d_type) {
    case DT_REG: return FileKind::regular;
    case DT_DIR: return FileKind::folder;
    case DT_LNK: return FileKind::link;
    case DT_UNKNOWN: return kind_of(name_in(folder, entry.d_name), Link::refused).value_or(FileKind::other);
    default: return FileKind::other;
  }
}

}  // namespace

Result<std::vector<FolderEntry>> entries_of(std::string const& folder) {
  std::unique_ptr<DIR, FolderCloser> const stream(::opendir(folder.empty() ? "." : folder.c_str()));
  if (!stream) return last_error();
  std::vector<FolderEntry> entries;
  while (true) {
    errno = 0;
    dirent const* const entry = ::readdir(stream.get());
    if (entry == nullptr) break;
    std::string name = entry->d_name;
    if (name != "." && name != "..") entries.push_back({std::move(name), kind_in(folder, *entry)});
  }
  if (errno != 0) return last_error();
  std::sort(entries.begin(), entries.end(),
            [](FolderEntry const& left, FolderEntry const& right) { return left.name < right.name; });
  return entries;
}

}  // namespace axisc::system
