// Which program this is: results of another one must not be taken for its own.
#pragma once

#include "cli/fleet/digest.hpp"

namespace axisc::cli {

/// Version and build: the linker's identity of the program (a digest of its code and of the schema in it), or a digest of
/// the program file where it was linked without. The same for copies of one program.
[[nodiscard]] Digest program_digest();

}  // namespace axisc::cli
