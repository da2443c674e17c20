// Where a list lies that a start-up list names. Its path counts from the control's working folder, which nobody here
// knows.
#pragma once

#include "configuration/files.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace axisc::configuration {

struct FoundList {
  std::string path;
  bool beside = false;  ///< not where its path says: a file of its name lies beside the start-up list
};

/// Looks for `named` from the folder of `start_up` and from each folder above it, then for its name alone beside the
/// start-up list; where no name is written like that, in any letter case. `\` separates as `/` does, and a first part
/// CncKernelRootDir is left out.
[[nodiscard]] std::optional<FoundList> find_list(Files& files, std::string const& start_up,
                                                 std::string_view named);

}  // namespace axisc::configuration
