// An axis in its position loop whose mechanics vibrate: a task for Improved Position Control.
//
// The axis moves as its lists and the slope of its channel let it, travels for half a second, and stops. How
// much a resonance swings is the largest amplitude of the load's acceleration around its frequency, while
// travelling or in the half second after the stop.
#pragma once

#include "analysis/motion/closed_loop.hpp"
#include "analysis/motion/plant.hpp"
#include "analysis/tuning/suggestion/task.hpp"
#include "configuration/machine/machine.hpp"
#include "design/units.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace axisc::tuning {

struct LoopTask {
  design::CycleTime cycle_time;
  machine::AxisConfiguration axis;  ///< its filters stay as they are from start-up; its stages do not count
  motion::PlantParameters plant;
  std::vector<Resonance> resonances;
  double velocity = 0;            ///< position units per cycle
  motion::PathDynamics dynamics;  ///< of the axis alone, with the slope of its channel
  double radius = 0;              ///< of a circle on which the axis travels at the velocity, position units
  double tolerance = 0;           ///< by which the function may move the load on it, position units
  bool least_vibration =
      false;  ///< whatever it costs within the tolerance; else half of the vibration may stay
};

[[nodiscard]] motion::AxisMove move_of(LoopTask const& task);

/// Shares of a resonance's frequency within which it is looked for: frequency_tolerance, or twice the
/// uncertainty where that is more.
[[nodiscard]] double reach_of(Resonance const& resonance);

/// The plant itself, and with all natural frequencies lower and higher by the largest reach: masses and
/// positions change.
[[nodiscard]] std::vector<motion::PlantParameters> plants_of(LoopTask const& task);

/// Cycles of the way there and of the half second after it, which count. The rest shows whether the loop
/// diverges.
[[nodiscard]] std::size_t counted_cycles(motion::LoopRecord const& record);

/// Accelerations in m/s² while travelling and at rest after it; so is the answer.
struct LoadAccelerations {
  std::span<double const> travel, rest;
};
[[nodiscard]] double swing(LoadAccelerations const& load, double cycle_seconds, Resonance const& resonance);

}  // namespace axisc::tuning
