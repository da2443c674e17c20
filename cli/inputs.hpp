// From the names on the command line to the lists and machine files that are checked.
#pragma once

#include "cli/failure.hpp"

#include <string>
#include <vector>

namespace axisc::cli {

struct Inputs {
  std::vector<std::string> paths;  ///< lists and machine files, in the order in which they are reported
  std::vector<Failure> failures;   ///< names that cannot be used
};

/// A folder stands for every list and machine file below it, sorted. A file that is named twice, and a list that one of
/// the machine files names, is checked once. Whether a named file exists is found out when it is read.
[[nodiscard]] Inputs expand_inputs(std::vector<std::string> const& named);

}  // namespace axisc::cli
