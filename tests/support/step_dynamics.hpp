// An axis that moves alone with STEP.
#pragma once

#include "analysis/motion/planning/axis_mode.hpp"
#include "analysis/motion/point.hpp"

namespace axisc::test {

/// One acceleration up and down, units per cycle²; the feed alone limits its velocity.
[[nodiscard]] inline motion::PathDynamics step_dynamics(double acceleration,
                                                        design::CycleTime cycle_time = {1'000'000}) {
  double const T = cycle_time.seconds();
  double const mm_per_s2 = acceleration / (motion::units_per_mm * T * T);
  machine::AxisDynamics axis;
  axis.feed.velocity = 2e9;
  axis.feed.step_up = axis.feed.step_down = {.first = mm_per_s2, .second = mm_per_s2};
  motion::PathDynamics dynamics;
  dynamics.axes = {axis};
  dynamics.cycle_time = cycle_time;
  return dynamics;
}

/// Its acceleration.
[[nodiscard]] inline double step_acceleration(motion::PathDynamics const& dynamics) {
  double const T = dynamics.cycle_time.seconds();
  return dynamics.axes.front().feed.step_up.first * motion::units_per_mm * T * T;
}

}  // namespace axisc::test
