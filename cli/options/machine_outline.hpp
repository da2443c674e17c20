// What the command line needs from a machine file before the validator checks it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace axisc::cli {

struct MachineOutline {
  bool is_machine = false;  ///< a JSON object with the key "axes", or something that tries to be one
  bool has_cycle_time =
      false;  ///< the key "cycle_time_us" is there; true as well where the file cannot be read
  std::vector<std::string>
      named;  ///< the lists and NC programs it names, as written: relative to the machine file
};

[[nodiscard]] MachineOutline read_machine_outline(std::string_view json);

/// True for a name that ends in `extension` (".json"), in upper or lower case.
[[nodiscard]] bool has_extension(std::string_view path, std::string_view extension);

}  // namespace axisc::cli
