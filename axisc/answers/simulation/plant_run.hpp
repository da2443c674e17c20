// An axis in its closed loop, there and back, with and without Improved Position Control.
#pragma once

#include "analysis/motion/closed_loop.hpp"
#include "axisc/answers/simulation/plant_formats.hpp"
#include "axisc/checking/path_machine.hpp"

#include <string>
#include <utility>

namespace axisc {

struct PlantRequest {
  std::string machine_path;
  std::string plant_path;
  std::string move;  ///< AXIS:MM or AXIS:MM:MM_PER_MIN
};

/// What a move gave, without and with the function.
struct PlantRun {
  ClosedLoopFigures figures;
  motion::LoopRecord without, with;
  double cycle_seconds = 0;
};

/// `searches_kv`: also finds the highest Kv, which takes most of the time. Failure for a move or a plant file
/// that cannot be used.
[[nodiscard]] PlantRun run_plant(PlantRequest const& request, CheckedMachine const& checked,
                                 bool searches_kv);

/// The band of frequencies in which oscillations are looked for, in Hz.
[[nodiscard]] std::pair<double, double> oscillation_band(double cycle_seconds);

}  // namespace axisc
