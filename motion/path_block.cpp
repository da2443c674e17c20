#include "motion/path_block.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::motion {
namespace {

/// A component this small is none: the axis rests.
constexpr double no_motion = 1e-15;

}  // namespace

double PathLimits::velocity(Point const& direction) const {
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    double const share = std::abs(direction[i]);
    if (share > no_motion) lowest = std::min(lowest, axes_[i].velocity / share);
  }
  return lowest;
}

double PathLimits::acceleration(Point const& direction) const {
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    double const share = std::abs(direction[i]);
    if (share > no_motion) lowest = std::min(lowest, axes_[i].acceleration / share);
  }
  return lowest;
}

double PathLimits::corner(Point const& turn, double acceleration_factor) const {
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    double const change = std::abs(turn[i]);
    // Directions are computed from rounded end points.
    if (change < 1e-12) continue;
    double const step = axes_[i].acceleration * (1 + axes_[i].transition_weight * acceleration_factor);
    lowest = std::min(lowest, step / change);
  }
  return lowest;
}

}  // namespace axisc::motion
