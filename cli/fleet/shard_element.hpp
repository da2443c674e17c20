// One finding of a shard's result, with what the whole run needs to know of it.
#pragma once

#include "cli/checking/checked_input.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::cli {

// None where the text is no finding.
[[nodiscard]] std::optional<WrittenFinding> read_json_element(std::string_view element);
/// `artifacts` are those of the input, of which the finding may name some.
[[nodiscard]] std::optional<WrittenFinding> read_sarif_element(std::string_view element,
                                                               std::vector<Artifact> const& artifacts);

/// A path as SARIF's reference names it, so that writing it gives the same reference again.
[[nodiscard]] std::string path_of_uri(std::string_view uri);

}  // namespace axisc::cli
