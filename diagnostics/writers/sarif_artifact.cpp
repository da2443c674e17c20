#include "diagnostics/writers/sarif_artifact.hpp"

namespace axisc {

ArtifactName artifact_name(RepositoryPaths const& paths, std::string_view file) {
  if (auto const path = path_in_repository(paths, file)) return {.uri = as_uri(*path), .in_repository = true};
  bool const is_absolute = file.substr(0, 1) == "/";
  return {.uri = (is_absolute ? "file://" : "") + as_uri(file), .in_repository = false};
}

}  // namespace axisc
