// Looks at an emitted path as a stranger would: from its phases' numbers and the lists, in mm and s, without
// any of the planner's formulas.
#pragma once

#include "planned_path.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace axisc::test {

/// Largest shares of limits, which are at most 1, and largest steps of what is continuous.
struct OracleFigures {
  double velocity = 0, acceleration = 0, jerk = 0;
  double curve = 0, curve_jerk = 0;
  double corner = 0, curvature_step = 0;
  double time = 0;      ///< shortest time without limited jerk, of a block's
  double stopping = 0;  ///< way to stop without limited jerk, of the blocks that are known
  double position_step = 0, velocity_step = 0, acceleration_step = 0;
  std::size_t blocks = 0;

  [[nodiscard]] double largest_share() const;
};

/// The blocks as they were asked for, without those of length 0.
void look_at(PlannedPath const& path, std::vector<motion::ProgrammedBlock> const& asked,
             motion::PathDynamics const& dynamics, OracleFigures& figures);

}  // namespace axisc::test
