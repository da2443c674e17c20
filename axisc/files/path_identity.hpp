// Whether two names mean one file.
#pragma once

#include <filesystem>
#include <string>
#include <unordered_map>

namespace axisc {

/// Paths with all links resolved; "-" stays. A folder is resolved once: resolving every file would cost more
/// than reading it.
class PathIdentities {
 public:
  [[nodiscard]] std::string of(std::string const& path);
  /// For a caller that knows whether `name` is a symbolic link.
  [[nodiscard]] std::string of(std::string const& name, bool is_link);

 private:
  std::unordered_map<std::string, std::string> folders_;
};

/// Where a symbolic link leads, even if nothing is there yet; other paths unchanged.
[[nodiscard]] std::string behind_links(std::string const& path);

}  // namespace axisc
