// The files that `--fix` and `fmt` may change.
#pragma once

#include <string>
#include <unordered_set>
#include <vector>

namespace axisc {

/// Files that the user names, and those below a folder that the user names; the folder of a machine file
/// counts as named. A machine file, which may come from anywhere, cannot name others. Links are resolved
/// first.
class ChangeableFiles {
 public:
  explicit ChangeableFiles(std::vector<std::string> const& named);
  [[nodiscard]] bool contains(std::string const& path) const;

 private:
  std::unordered_set<std::string> files_;
  std::unordered_set<std::string> folders_;
};

}  // namespace axisc
