// Paths as code hosts name them: relative to the root of the repository, with slashes.
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

/// `C:` and whatever follows.
[[nodiscard]] bool begins_with_drive(std::string_view path);

/// `axes/x.lis` for a file below the root; none for a file elsewhere and for "-", standard input.
/// Where the root has a drive, names have one too, and upper and lower case are the same.
[[nodiscard]] std::optional<std::string> path_in_repository(RepositoryPaths const& paths,
                                                            std::string_view file);

/// The path in the repository if there is one, otherwise the name unchanged.
[[nodiscard]] std::string shown_path(RepositoryPaths const& paths, std::string_view file);

/// A URI reference: characters that are not allowed are percent-encoded, slashes are kept.
[[nodiscard]] std::string as_uri(std::string_view path);

}  // namespace axisc
