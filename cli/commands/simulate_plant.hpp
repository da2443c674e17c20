// `axisc simulate --plant`.
#pragma once

#include "cli/commands/commands.hpp"
#include "cli/execution/plant_run.hpp"
#include "cli/formats/simulate_formats.hpp"

#include <optional>
#include <string>

namespace axisc::cli {

struct SimulatedPlant {
  PlantRequest request;
  std::optional<std::string> output;
  SimulateFormat format = SimulateFormat::text;
};

[[nodiscard]] ExitStatus simulate_plant(SimulatedPlant const& asked, CheckedMachine const& checked,
                                        Invocation const& invocation);

}  // namespace axisc::cli
