// Zip archives, such as FMUs are.
#pragma once

#include "image/c_sources.hpp"

#include <string>
#include <vector>

namespace axisc::image {

/// The files in the order of their names, which are of ASCII with `/`, all of them of 1980-01-01: the same
/// bytes for the same files. Less than 4 GiB.
[[nodiscard]] std::string zip_archive(std::vector<ExportedFile> files);

}  // namespace axisc::image
