#include "analysis/motion/path_block.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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

double PathLimits::velocity(Segment const& arc) const {
  auto const& circle = *arc.arc();
  auto const& first = axes_[circle.first];
  auto const& second = axes_[circle.second];
  Point aside = arc.direction_at(0);
  aside[circle.first] = aside[circle.second] = 0;
  double const in_plane = std::min(first.velocity, second.velocity) / circle.share;
  double const bent = std::sqrt(std::min(first.acceleration, second.acceleration) *
                                circle.curvature_radius() / std::numbers::sqrt2);
  return std::min({velocity(aside), in_plane, bent});
}

double PathLimits::acceleration(Segment const& arc, double velocity) const {
  auto const& circle = *arc.arc();
  Point aside = arc.direction_at(0);
  aside[circle.first] = aside[circle.second] = 0;
  double const most = std::min(axes_[circle.first].acceleration, axes_[circle.second].acceleration);
  double const across = std::min(velocity * velocity / circle.curvature_radius(), most / std::numbers::sqrt2);
  double const along = std::sqrt(most * most - across * across) / circle.share;
  return std::min(acceleration(aside), along);
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
