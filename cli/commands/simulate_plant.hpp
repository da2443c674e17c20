// `axisc simulate --plant`: an axis in its closed loop, with and without Improved Position Control.
#pragma once

#include "cli/commands/commands.hpp"
#include "cli/commands/simulate_program.hpp"
#include "cli/files/path_machine.hpp"

#include <optional>
#include <string>

namespace axisc::cli {

struct PlantRequest {
  std::string machine_path;
  std::string plant_path;
  std::string move;
  std::optional<std::string> output;
  SimulateFormat format = SimulateFormat::text;
};

[[nodiscard]] ExitStatus simulate_plant(PlantRequest const& request, CheckedMachine const& checked,
                                        Invocation const& invocation);

}  // namespace axisc::cli
