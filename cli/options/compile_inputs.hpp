// The inputs of `axisc compile`, and the paths of their images.
#pragma once

#include "axisc/environment/failure.hpp"
#include "axisc/workspace/workspace.hpp"
#include "cli/options/compile_options.hpp"

#include <string>
#include <vector>

namespace axisc::cli {

struct CompileInputs {
  Inputs inputs;
  std::vector<std::string> images;  ///< by input
};

/// Without lists and programs that a machine reads, unless `--alone` is given. Failure for inputs that cannot
/// become an image, and for two images of the same name.
[[nodiscard]] CompileInputs choose_inputs(CompileOptions const& options, Workspace& workspace);

}  // namespace axisc::cli
