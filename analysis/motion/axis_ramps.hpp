// How an axis that moves alone reaches a velocity, and how it brakes.
#pragma once

#include "analysis/motion/planning/axis_mode.hpp"
#include "analysis/motion/planning/ramp.hpp"

namespace axisc::motion {

struct AxisRamps {
  Ramp up, down;
};

/// Of a feed block (G01). `alone` has the axis, and the slope of its channel.
[[nodiscard]] AxisRamps axis_ramps(PathDynamics const& alone);

}  // namespace axisc::motion
