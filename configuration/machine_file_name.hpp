// The name by which a machine file is known, whatever is in it.
#pragma once

#include "diagnostics/ascii.hpp"

#include <string_view>

namespace axisc::configuration {

/// True for `machine.json`, in any folder and letter case.
[[nodiscard]] inline bool is_machine_file_name(std::string_view path) {
  return ascii::equal_ignoring_case(path.substr(path.find_last_of("/\\") + 1), "machine.json");
}

}  // namespace axisc::configuration
