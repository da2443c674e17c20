// Files of an export, on the disk.
#pragma once

#include "image/c_sources.hpp"

#include <string>
#include <vector>

namespace axisc {

/// Writes each file into the folder, which is made where there is none; a file that has its content already
/// is not touched. Failure (AX9002) where one of them is among `sources`, before anything is written, and for
/// a write error.
void write_files(std::string const& folder, std::vector<image::ExportedFile> const& files,
                 std::vector<std::string> const& sources);

/// One file, in the same way.
void write_file(std::string const& path, std::string const& content, std::vector<std::string> const& sources);

}  // namespace axisc
