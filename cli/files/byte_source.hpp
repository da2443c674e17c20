// The bytes of a file, piece by piece.
#pragma once

#include "cli/report/csv.hpp"

#include <string>

namespace axisc::cli {

/// The file is open as long as the source lives; "-" is standard input. Failure AX9001 where it cannot be read.
[[nodiscard]] ByteSource open_source(std::string const& path);

}  // namespace axisc::cli
