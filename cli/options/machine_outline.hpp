// What the command line needs from a machine file before the validator checks it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace axisc::cli {

struct MachineOutline {
  bool is_machine = false;  ///< a JSON object with the key "axes", or something that tries to be one
  // What it names, as written: relative to the machine file.
  std::vector<std::string> lists = {};
  std::vector<std::string> programs = {};
};

[[nodiscard]] MachineOutline read_machine_outline(std::string_view json);

/// True for a name that ends in `extension` (".json"), in upper or lower case.
[[nodiscard]] bool has_extension(std::string_view path, std::string_view extension);

}  // namespace axisc::cli
