// The inputs of `axisc compile`, and the paths of their images.
#pragma once

#include "axisc/environment/failure.hpp"
#include "axisc/settings/settings.hpp"
#include "axisc/workspace/inputs.hpp"
#include "cli/options/compile_options.hpp"

#include <string>
#include <vector>

namespace axisc::cli {

struct CompileInputs {
  std::vector<std::string> paths;
  std::vector<std::string> images;                    ///< by input
  std::vector<Failure> failures;                      ///< names of a batch that cannot be used
  std::vector<Message> notes;                         ///< see Inputs
  std::vector<std::string> sources;                   ///< see Inputs
  std::unordered_map<std::string, FoundInput> found;  ///< see Inputs
};

/// Failure for inputs that cannot become an image, and for two images of the same name.
[[nodiscard]] CompileInputs choose_inputs(CompileOptions const& options, SettingsFinder& settings);

}  // namespace axisc::cli
