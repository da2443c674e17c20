// Questions about what a scope recorded.
#pragma once

#include "axisc/checking/machine_input.hpp"
#include "axisc/interface/asked.hpp"
#include "axisc/workspace/workspace.hpp"

#include <optional>
#include <string>

namespace axisc::interface {

// As answer() in questions.hpp; the recordings are read from the disk.

[[nodiscard]] std::optional<std::string> compare(Workspace& workspace, Asked const& asked,
                                                 ErrorSink const& errors);
/// A recording need not be.
[[nodiscard]] std::optional<std::string> circle(Workspace& workspace, Asked const& asked,
                                                ErrorSink const& errors);
[[nodiscard]] std::optional<std::string> identify(Workspace& workspace, Asked const& asked,
                                                  ErrorSink const& errors);

}  // namespace axisc::interface
