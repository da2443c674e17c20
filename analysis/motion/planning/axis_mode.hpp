// What the axes allow in one kind of block: the lists' values with the weights of the program, per cycle.
//
// A weight above 100 % counts up to P-AXIS-00292, or `a_max` where a list does not set it; ramp times stay
// above P-AXIS-00293. Velocities stay below vb_max; 0 % is 1 µm/s. HSC gives each ramp the longest of an
// axis' four times.
#pragma once

#include "analysis/motion/block_dynamics.hpp"
#include "analysis/motion/planning/ramp.hpp"
#include "configuration/machine/path_dynamics.hpp"
#include "design/units.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace axisc::motion {

/// What lists and settings say about the path of a channel.
struct PathDynamics {
  std::vector<machine::AxisDynamics> axes;  ///< in the order of the path
  machine::ChannelDynamics channel;
  machine::MotionReadings readings;
  design::CycleTime cycle_time;
};

/// An axis that gains, or loses, velocity. Units and cycles.
struct AxisRamp {
  double first = 0, second = 0, changeover = 0;  ///< STEP: the stages' accelerations
  double acceleration = 0;                       ///< other slopes
  double build_up = 0, take_back = 0;

  /// STEP: at a velocity.
  [[nodiscard]] double stage(double velocity) const { return velocity > changeover ? second : first; }
};

struct AxisMode {
  double velocity = 0;
  AxisRamp up, down;
  double curve_ramp = 0;  ///< cycles
  /// Largest change of velocity from one cycle to the next at a corner, w a T, of slopes other than STEP.
  double corner_step = 0;
  /// Largest change of the acceleration where a curve begins or ends, w' a.
  double curve_step = 0;
};

struct BlockMode {
  machine::Slope slope = machine::Slope::step;
  RampRules rules;
  bool across_blocks = false;  ///< the acceleration need not be 0 at the block's ends
  bool limits_corners = true, limits_curves = true, limits_curvature_steps = false;
  machine::ProjectionReading projection = {};
  machine::CircleReading circle = {};
  machine::CornerReading corner = {};
  /// #VECTOR LIMIT, units and cycles; on circles `acceleration` counts only where `limits_circles`.
  double vector_velocity = 0, vector_up = 0, vector_down = 0, vector_radial = 0;
  bool limits_circles = false;
  double least_corner_velocity = 0;
  std::size_t axis_count = 0;
  std::array<AxisMode, most_axes> axes{};
};

/// `words` null: nothing was said. `acceleration_factor` is ACC_FACT.
[[nodiscard]] BlockMode block_mode(PathDynamics const& dynamics, BlockDynamics const* words, bool rapid,
                                   double acceleration_factor);

}  // namespace axisc::motion
