// The content of a folder.
#pragma once

#include "system/error.hpp"
#include "system/file.hpp"

#include <string>
#include <vector>

namespace axisc::system {

struct FolderEntry {
  std::string name;
  FileKind kind = FileKind::other;  ///< links are not followed
};

/// In the order of the names, byte by byte; without `.` and `..`. An empty name is the working folder.
[[nodiscard]] Result<std::vector<FolderEntry>> entries_of(std::string const& folder);
/// `folder/name`; the name alone in the working folder.
[[nodiscard]] std::string name_in(std::string const& folder, std::string const& name);

}  // namespace axisc::system
