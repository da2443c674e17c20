// Questions as JSON objects, for other languages.
#pragma once

#include "axisc/checking/machine_input.hpp"
#include "axisc/workspace/workspace.hpp"

#include <optional>
#include <string>

namespace axisc::web {

/// The answer in the format that the question names. None after errors in lists, which `errors` takes.
/// Failure for a question that is none.
[[nodiscard]] std::optional<std::string> answer(Workspace& workspace, std::string const& question,
                                                ErrorSink const& errors);

}  // namespace axisc::web
