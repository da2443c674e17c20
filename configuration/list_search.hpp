// Finds a list that a start-up list names. Its path counts from the control's working folder, which is not
// known here.
#pragma once

#include "configuration/files.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace axisc::configuration {

struct FoundList {
  std::string path;
  bool moved = false;  ///< not where its path leads: no folder of that name is there
  std::optional<std::string> other = std::nullopt;  ///< another file that the name may mean just as well
};

/// Looks for `named`, in this order:
/// 1. from the folder of `start_up` and from each folder above it;
/// 2. without its first folder, which may have been renamed in a copy, from the same folders;
/// 3. without more of its folders, down to its name alone, from the folder of `start_up`.
/// 2 and 3 only as long as the folder that the name asks for is nowhere: a file that is not in its folder is
/// missing. Names match in any letter case where none is written like that. `\` separates as `/` does, and a
/// first part CncKernelRootDir is left out.
[[nodiscard]] std::optional<FoundList> find_list(Files& files, std::string const& start_up,
                                                 std::string_view named);

}  // namespace axisc::configuration
