#include "analysis/motion/axis_ramps.hpp"

#include "analysis/motion/path_block.hpp"

namespace axisc::motion {

AxisRamps axis_ramps(PathDynamics const& alone) {
  ProgrammedBlock along;
  along.end[0] = 1;
  auto const block = PathLimits(alone).block(along, {}, 1, along.feed, false);
  return {.up = block.up, .down = block.down};
}

}  // namespace axisc::motion
