// Files that differ from a revision in git.
#pragma once

#include <string>
#include <unordered_set>
#include <vector>

namespace axisc {

/// Paths count from the root of the repository.
struct ChangedFiles {
  std::string root;                       ///< of the working folder's repository
  std::unordered_set<std::string> paths;  ///< files that differ, are new or are gone; submodules that differ
  std::vector<std::string> gone;          ///< of these
};

/// Compares the files on the disk with the revision. Files that git does not know yet are new, except ignored
/// ones. Failure without git, outside of a repository and for a revision that it does not have.
[[nodiscard]] ChangedFiles changed_since(std::string const& revision);

}  // namespace axisc
