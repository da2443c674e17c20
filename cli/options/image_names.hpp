// Where the images of a batch go.
#pragma once

#include <string>
#include <vector>

namespace axisc::cli {

/// For each input its path below `input_folder` (empty: the working folder), below `output_folder`, with .axim instead of
/// its extension. Failure for an input that lies elsewhere, for standard input, and where two inputs have one name.
[[nodiscard]] std::vector<std::string> image_names(std::vector<std::string> const& inputs,
                                                   std::string const& input_folder,
                                                   std::string const& output_folder);

}  // namespace axisc::cli
