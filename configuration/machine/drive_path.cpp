#include "configuration/machine/drive_path.hpp"

#include <cmath>

namespace axisc::machine {

PositionDelay position_delay(DrivePath const& path) {
  PositionDelay sum;
  for (DriveDelay const& delay : path.delays) {
    if (delay.kind == DelayKind::lag) continue;
    double const whole = delay.kind == DelayKind::balancing ? 0 : std::floor(delay.position);
    sum.cycles += whole;
    sum.lag += delay.position - whole;
  }
  return sum;
}

}  // namespace axisc::machine
