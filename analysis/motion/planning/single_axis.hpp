// One axis of a channel alone, from rest over a way to rest, as the look-ahead plans it with the lists'
// values.
#pragma once

#include "analysis/motion/planning/axis_mode.hpp"
#include "analysis/motion/planning/phase.hpp"

#include <vector>

namespace axisc::motion {

/// Position units and cycles.
struct SingleMove {
  double length = 0;
  double feed = 0;  ///< does not count in G00
  bool rapid = false;
};

/// From rest to rest. `axis` has one axis. Empty for a length of 0.
[[nodiscard]] std::vector<Phase> phases_of(PathDynamics const& axis, SingleMove const& move);

}  // namespace axisc::motion
