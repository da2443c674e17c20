// A file as SARIF names it.
#pragma once

#include "diagnostics/repository_path.hpp"

#include <string>
#include <string_view>

namespace axisc {

/// The name for the root of the repository.
inline constexpr std::string_view artifact_root = "SRCROOT";

struct ArtifactName {
  std::string uri;
  bool in_repository = false;  ///< `uri` counts from the root
};

[[nodiscard]] ArtifactName artifact_name(RepositoryPaths const& paths, std::string_view file);

}  // namespace axisc
