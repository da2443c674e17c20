// The sample machine of these tests as an image, for the commands that read one.
#pragma once

#include "cli/program.hpp"
#include "support/temporary_folder.hpp"

#include <string>

namespace axisc::test {

/// Compiles the machine to `m.axim` in `folder`; commands then run there.
[[nodiscard]] inline Surroundings compiled(TemporaryFolder const& folder) {
  Surroundings there = in_folder(folder.path());
  std::string const machine = std::string(AXISC_SOURCE_DIR) + "/tests/cli/data/machine/machine.json";
  REQUIRE(run_axisc({"compile", machine, "-o", "m.axim", "--quiet"}, there).status == 0);
  return there;
}

}  // namespace axisc::test
