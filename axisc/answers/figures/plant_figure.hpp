// An axis in its closed loop, drawn.
#pragma once

#include "axisc/answers/simulation/plant_run.hpp"
#include "presentation/pictures/figure.hpp"

namespace axisc {

/// Following error and acceleration of the load over time, and the spectrum of its oscillation while
/// travelling and at rest after braking, without and with Improved Position Control: what `simulate --plant`
/// computes.
[[nodiscard]] pictures::Figure plant_figure(PlantRun const& run, Language language);

}  // namespace axisc
