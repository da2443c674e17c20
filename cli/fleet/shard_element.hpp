// One finding of a shard's result, with the facts that the whole run needs.
#pragma once

#include "cli/checking/checked_input.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::cli {

// None if the text is not a finding.
[[nodiscard]] std::optional<WrittenFinding> read_json_element(std::string_view element);
/// `artifacts` are those of the input; the finding may refer to them.
[[nodiscard]] std::optional<WrittenFinding> read_sarif_element(std::string_view element,
                                                               std::vector<Artifact> const& artifacts);

/// A path as SARIF's reference names it, so that writing it gives the same reference again.
[[nodiscard]] std::string path_of_uri(std::string_view uri);

}  // namespace axisc::cli
