// Machines as they occur, drawn at random.
#pragma once

#include "analysis/tuning/suggestion/task.hpp"
#include "support/step_dynamics.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

namespace axisc::test {

/// One to three resonances with dampings of 0.5 to 5 %.
inline tuning::Task random_task(std::uint32_t seed) {
  std::mt19937 random(seed);
  auto const between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  constexpr double units_per_mm = 1e4;
  tuning::Task task;
  std::array const cycle_times = {500'000U, 1'000'000U, 2'000'000U};
  task.cycle_time = {cycle_times[random() % cycle_times.size()]};
  double const T = task.cycle_time.seconds();
  auto const count = 1 + random() % 3;
  for (std::size_t i = 0; i < count; ++i) {
    task.resonances.push_back(
        {.frequency = std::exp(between(std::log(15), std::log(120))), .damping = between(0.005, 0.05)});
  }
  double const feed = between(500, 8000) / 60;
  task.velocity = feed * T * units_per_mm;
  task.dynamics = step_dynamics(between(500, 8000) * T * T * units_per_mm, task.cycle_time);
  task.tolerance = between(0.005, 0.05) * units_per_mm;
  task.radius = between(10, 50) * units_per_mm;
  return task;
}

}  // namespace axisc::test
