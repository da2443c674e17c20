// Paths of the images of a batch.
#pragma once

#include <string>
#include <vector>

namespace axisc {

/// For each input its path below `input_folder` (empty: the working folder), below `output_folder`, with
/// .axim instead of its extension. Failure for an input outside of that folder, for standard input, and if
/// two inputs get the same name.
[[nodiscard]] std::vector<std::string> image_names(std::vector<std::string> const& inputs,
                                                   std::string const& input_folder,
                                                   std::string const& output_folder);

}  // namespace axisc
