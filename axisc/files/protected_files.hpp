// Files that no output of any command may replace.
#pragma once

#include <string>
#include <vector>

namespace axisc {

/// Failure (AX9002), before anything is touched, where an output is one of the inputs, under whatever name,
/// where two outputs are one file, and where an output is a secret key. "-" and devices are exempt. Cost: one
/// or two system calls per name.
void refuse_overwriting(std::vector<std::string> const& outputs, std::vector<std::string> const& inputs);

}  // namespace axisc
