#include "diagnostics/writers/sarif_artifact.hpp"

namespace axisc {

ArtifactName artifact_name(RepositoryPaths const& paths, std::string_view file) {
  if (auto const path = path_in_repository(paths, file)) return {.uri = as_uri(*path), .in_repository = true};
  if (begins_with_drive(paths.root) && begins_with_drive(file)) {
    return {.uri = "file:///" + std::string(file.substr(0, 2)) + as_uri(file.substr(2)),
            .in_repository = false};
  }
  bool const is_absolute = file.substr(0, 1) == "/";
  return {.uri = (is_absolute ? "file://" : "") + as_uri(file), .in_repository = false};
}

}  // namespace axisc
