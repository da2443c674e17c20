// Other programs.
#pragma once

#include "system/error.hpp"

#include <string>
#include <vector>

namespace axisc::system {

struct ProgramOutcome {
  int status = 0;  ///< its exit status; not 0 where it did not end by itself
  std::string output;
  std::string errors;  ///< of its standard error
};

/// Runs the program `arguments.front()`, which is looked for in the folders of PATH, without a shell and
/// without input, and waits for its end. An error means that it could not be started.
[[nodiscard]] Result<ProgramOutcome> run_program(std::vector<std::string> const& arguments);

}  // namespace axisc::system
