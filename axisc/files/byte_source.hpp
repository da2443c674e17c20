// The bytes of a file, piece by piece.
#pragma once

#include "axisc/files/csv.hpp"

#include <string>

namespace axisc {

/// The file is open as long as the source lives; "-" is standard input. Failure AX9001 where it cannot be
/// read.
[[nodiscard]] ByteSource open_source(std::string const& path);

}  // namespace axisc
