// Files as a code host names them: from the root of the repository, with slashes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace axisc {

/// Two absolute paths without links, so that names can be compared as text.
struct RepositoryPaths {
  std::string root;    ///< of the repository; where there is none, that of the working folder
  std::string folder;  ///< the working folder, to which relative names belong
};

/// `axes/x.lis` for what lies below the root; nothing for what lies elsewhere and for "-", standard input.
[[nodiscard]] std::optional<std::string> path_in_repository(RepositoryPaths const& paths,
                                                            std::string_view file);

/// The path in the repository where there is one, else the name as it is.
[[nodiscard]] std::string shown_path(RepositoryPaths const& paths, std::string_view file);

/// A reference for an URI: what is not allowed there is percent-encoded, slashes stay.
[[nodiscard]] std::string as_uri(std::string_view path);

}  // namespace axisc
