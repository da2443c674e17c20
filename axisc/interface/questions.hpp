// Questions as JSON objects, for other languages.
#pragma once

#include "axisc/checking/machine_input.hpp"
#include "axisc/interface/asked.hpp"
#include "axisc/workspace/workspace.hpp"

#include <optional>
#include <string>

namespace axisc::interface {

/// The answer in the format that the question names. None after errors in lists, which `errors` takes.
/// BadArgument for a question that is none.
[[nodiscard]] std::optional<std::string> answer(Workspace& workspace, Asked const& asked,
                                                ErrorSink const& errors);

}  // namespace axisc::interface
