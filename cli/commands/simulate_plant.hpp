// `axisc simulate --plant`.
#pragma once

#include "axisc/answers/simulation/plant_run.hpp"
#include "axisc/answers/simulation/simulate_formats.hpp"
#include "cli/commands/commands.hpp"

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
