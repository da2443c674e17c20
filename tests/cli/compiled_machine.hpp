// The sample machine of these tests as an image, for the commands that read one.
#pragma once

#include "cli/program.hpp"
#include "support/temporary_folder.hpp"

#include <string>
#include <vector>

namespace axisc::test {

/// Compiles the machine, with `more` options, to `m.axim` in `folder`; commands then run there.
[[nodiscard]] inline Surroundings compiled(TemporaryFolder const& folder,
                                           std::vector<std::string> const& more = {}) {
  Surroundings there = in_folder(folder.path());
  std::string const machine = std::string(AXISC_SOURCE_DIR) + "/tests/cli/data/machine/machine.json";
  std::vector<std::string> arguments{"compile", machine, "-o", "m.axim", "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  REQUIRE(run_axisc(arguments, there).status == 0);
  return there;
}

}  // namespace axisc::test
