#include "analysis/tuning/position_control/loop_task.hpp"

#include "analysis/motion/axis_ramps.hpp"
#include "analysis/motion/spectrum.hpp"
#include "analysis/tuning/suggestion/excitation.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::tuning {
namespace {

constexpr double travel_seconds = 0.5;

motion::PlantParameters tuned(motion::PlantParameters plant, double share) {
  plant.stiffness *= share * share;
  plant.damping *= share;
  plant.structure_frequency *= share;
  return plant;
}

}  // namespace

motion::AxisMove move_of(LoopTask const& task) {
  double const travel = travel_seconds / task.cycle_time.seconds();
  auto const [up, down] = motion::axis_ramps(task.dynamics);
  return {.axis = 0,
          .distance = up.way(0, task.velocity) + task.velocity * travel + down.way(0, task.velocity),
          .velocity = task.velocity,
          .dynamics = task.dynamics};
}

double reach_of(Resonance const& resonance) {
  return std::max(frequency_tolerance, 2 * resonance.uncertainty / resonance.frequency);
}

std::vector<motion::PlantParameters> plants_of(LoopTask const& task) {
  double reach = 0;
  for (auto const& resonance : task.resonances) reach = std::max(reach, reach_of(resonance));
  return {task.plant, tuned(task.plant, 1 - reach), tuned(task.plant, 1 + reach)};
}

std::size_t counted_cycles(motion::LoopRecord const& record) {
  auto const first = [&](auto const& is_wanted) {
    return static_cast<std::size_t>(std::find_if(record.cycles.begin(), record.cycles.end(), is_wanted) -
                                    record.cycles.begin());
  };
  auto const rest =
      first([](motion::LoopCycle const& cycle) { return cycle.phase == motion::MovePhase::rest; });
  auto const back = first([](motion::LoopCycle const& cycle) { return cycle.back; });
  return rest + (back - rest) / 3;
}

double swing(LoadAccelerations const& load, double cycle_seconds, Resonance const& resonance) {
  double const reach = reach_of(resonance) * resonance.frequency;
  double largest = 0;
  for (auto const& record : {load.travel, load.rest}) {
    if (record.empty()) continue;
    // A quarter of the window's resolution: no peak is missed by more than 1 %.
    double const step = 0.25 / (static_cast<double>(record.size()) * cycle_seconds);
    auto const steps = static_cast<int>(std::ceil(reach / step));
    std::vector<double> frequencies;
    for (int i = -steps; i <= steps; ++i) frequencies.push_back(resonance.frequency + reach * i / steps);
    auto const amplitudes = motion::amplitudes_at(record, cycle_seconds, frequencies);
    largest = std::max(largest, *std::max_element(amplitudes.begin(), amplitudes.end()));
  }
  return largest;
}

}  // namespace axisc::tuning
