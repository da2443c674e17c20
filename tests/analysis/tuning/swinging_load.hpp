// A resonance that the axis carries, simulated with motion/plant: a stiff drive that follows its velocity,
// and on the load a structure too light to act back.
#pragma once

#include "analysis/motion/plant.hpp"
#include "analysis/tuning/suggestion/task.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace axisc::test {

/// Amplitude of the structure's oscillation (position units) at a cycle while setpoints (position units) are
/// driven.
inline double swing_at(std::vector<double> const& setpoints, std::size_t cycle,
                       tuning::Resonance const& resonance, double T) {
  constexpr double units_per_m = 1e7;
  constexpr double pi = std::numbers::pi;
  motion::PlantParameters parameters;
  parameters.motor_mass = 100;
  parameters.load_mass = 100;
  parameters.stiffness = 50 * std::pow(2 * pi * 1500, 2);
  parameters.damping = 2 * 0.7 * 50 * 2 * pi * 1500;
  parameters.structure_mass = 1e-6;
  parameters.structure_frequency = resonance.frequency;
  parameters.structure_damping = *resonance.damping;
  parameters.velocity_bandwidth = 1500;
  motion::Plant plant(parameters, T);
  double before = 0;
  for (std::size_t n = 0; n <= cycle; ++n) {
    double const setpoint =
        n < setpoints.size() ? setpoints[n] : 2 * before - setpoints[setpoints.size() - 2];
    plant.step((setpoint - before) / T / units_per_m);
    before = setpoint;
  }
  double const omega = 2 * pi * resonance.frequency;
  double const damping = *resonance.damping;
  double const damped = omega * std::sqrt(1 - damping * damping);
  auto const motion = plant.motion();
  double const x = motion.structure_position - motion.load_position;
  double const v = motion.structure_velocity - motion.load_velocity;
  return std::hypot(x, (v + damping * omega * x) / damped) * units_per_m;
}

}  // namespace axisc::test
