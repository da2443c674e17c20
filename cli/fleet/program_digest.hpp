// Identity of this program, so that results of other builds are not reused.
#pragma once

#include "cli/fleet/digest.hpp"

namespace axisc::cli {

/// Version and build: the linker's identity of the program (a digest of its code and of the schema in it), or a digest
/// of the program file if it was linked without one. Equal for copies of one program.
[[nodiscard]] Digest program_digest();

}  // namespace axisc::cli
