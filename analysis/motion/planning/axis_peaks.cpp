#include "analysis/motion/planning/axis_peaks.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::motion {

void AxisPeaks::take(PathBlock const& block, Phase const& phase) {
  jumps = jumps || block.mode->slope == machine::Slope::step;
  auto const raise = [this](std::size_t axis, double a, double j) {
    acceleration[axis] = std::max(acceleration[axis], a);
    jerk[axis] = std::max(jerk[axis], j);
  };
  auto const* const arc = block.path.arc();
  auto direction = block.path.direction_at(0);
  if (arc != nullptr) direction[arc->first] = direction[arc->second] = 0;
  // Acceleration and jerk are largest at an end, a sine's jerk in the middle.
  for (double const time : {0.0, phase.duration / 2, phase.duration}) {
    double const v = phase.velocity_at(time);
    double const a = phase.acceleration_at(time);
    double const j = phase.jerk_at(time);
    for (std::size_t i = 0; i < block.mode->axis_count; ++i) {
      double const share = std::abs(direction[i]);
      if (share > 0) raise(i, share * std::abs(a), share * std::abs(j));
    }
    if (arc == nullptr) continue;
    double const radius = arc->curvature_radius();
    double const turned = v * v * v / (radius * radius) / (arc->share * arc->share);
    double const found_a = std::hypot(a * arc->share, v * v / radius);
    double const found_j = std::hypot((j - turned) * arc->share, 3 * v * a / radius);
    raise(arc->first, found_a, found_j);
    raise(arc->second, found_a, found_j);
  }
}

}  // namespace axisc::motion
