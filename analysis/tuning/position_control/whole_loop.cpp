#include "analysis/tuning/position_control/whole_loop.hpp"

#include "analysis/tuning/position_control/loop_answer.hpp"
#include "analysis/tuning/position_control/loop_trials.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::tuning {
namespace {

using machine::PositionControl;

/// The largest limit that P-AXIS-00757 allows.
constexpr double highest_limit = 2000;

double swing_of(motion::LoopRecord const& record, double cycle_seconds, Resonance const& resonance) {
  auto const travel = motion::load_accelerations(record, motion::MovePhase::travel, false);
  auto const rest = motion::load_accelerations(record, motion::MovePhase::rest, false);
  return swing({.travel = travel, .rest = rest}, cycle_seconds, resonance);
}

void compare(motion::LoopRecord const& without, motion::LoopRecord const& with, Damping& found) {
  for (std::size_t n = 0; n < counted_cycles(with); ++n) {
    auto const& a = without.cycles[n];
    auto const& b = with.cycles[n];
    found.additive_velocity = std::max(found.additive_velocity, std::abs(b.additive_velocity));
    found.shift = std::max(found.shift, std::abs(b.load_position - a.load_position));
    found.error_without = std::max(found.error_without, std::abs(a.load_position - a.setpoint));
    found.error_with = std::max(found.error_with, std::abs(b.load_position - b.setpoint));
  }
}

}  // namespace

PositionControl with_doubled_weights(PositionControl control) {
  for (auto& stage : control.stages) {
    stage.weight_numerator = std::min(2 * stage.weight_numerator, largest_weight * stage.weight_denominator);
  }
  return control;
}

bool keeps_margin(LoopTask const& task, std::span<motion::PlantParameters const> plants,
                  PositionControl const& control) {
  for (auto const& tried : {control, with_doubled_weights(control)}) {
    auto runtime = loop_runtime(task, tried);
    for (auto const& plant : plants) {
      auto const record = motion::simulate_loop(runtime, move_of(task), plant, true);
      if (motion::diverges(record, task.cycle_time.seconds())) return false;
    }
  }
  return true;
}

double limit_for(LoopTask const& task, std::span<motion::PlantParameters const> plants,
                 PositionControl const& control) {
  auto runtime = loop_runtime(task, control);
  double largest = 0;
  for (auto const& plant : plants) {
    auto const record = motion::simulate_loop(runtime, move_of(task), plant, true);
    for (auto const& cycle : record.cycles) largest = std::max(largest, std::abs(cycle.additive_velocity));
  }
  return std::clamp(std::ceil(2 * largest / task.axis.velocity_limit * whole_velocity), 1.0, highest_limit);
}

void measure(LoopTask const& task, std::span<motion::PlantParameters const> plants, Damping& found) {
  double const T = task.cycle_time.seconds();
  auto runtime = loop_runtime(task, found.control);
  for (auto const& plant : plants) {
    auto const without = motion::simulate_loop(runtime, move_of(task), plant, false);
    auto const with = motion::simulate_loop(runtime, move_of(task), plant, true);
    bool const is_own = &plant == &plants.front();
    for (std::size_t i = 0; i < task.resonances.size(); ++i) {
      auto& resonance = found.resonances[i];
      double const before = swing_of(without, T, task.resonances[i]);
      double const after = swing_of(with, T, task.resonances[i]);
      if (is_own) {
        resonance.without = before;
        resonance.with = after;
      }
      resonance.worst_without = std::max(resonance.worst_without, before);
      resonance.worst = std::max(resonance.worst, after);
    }
    if (is_own) compare(without, with, found);
  }
}

}  // namespace axisc::tuning
