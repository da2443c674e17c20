// Lets the runtime pass a corner as tolerance monitoring would: with a plateau around it, and ramps before and behind.
#pragma once

#include "motion/chain_answer.hpp"
#include "motion/group_runtime.hpp"
#include "motion/point.hpp"

#include <span>
#include <vector>

namespace axisc::motion {

/// A place where the direction of the path changes, between two straight blocks.
struct Corner {
  double place = 0;                                         ///< along the path, units
  Point before{};                                           ///< unit vector of the path up to it
  Point turn{};                                             ///< the unit vector behind it less that one
  double velocity_before = 0, velocity_behind = 0;          ///< most that the blocks allow, units per cycle
  double acceleration_before = 0, acceleration_behind = 0;  ///< along them, units per cycle²
  double velocity = 0;                                      ///< that the tolerance allows; infinite: any
};

/// Cycles that the plateau reaches to either side of a corner: the kernels' h, where R = 0, and one by which the setpoints
/// on either side of a corner may lie away from it.
[[nodiscard]] double plateau_cycles(std::span<ChainAnswer const> answers);

class CornerProbe {
 public:
  /// Both live longer; the runtime is switched as `answers` say, and will be reset again and again.
  CornerProbe(GroupRuntime& runtime, std::span<ChainAnswer const> answers);

  /// Largest axis error around the corner for a plateau of this velocity, tried with the corner at so many places
  /// between two cycles.
  [[nodiscard]] double largest_axis_error(Corner const& corner, double plateau, int phases);

 private:
  [[nodiscard]] Point nominal(Corner const& corner, double plateau, double tau) const;
  void execute(Corner const& corner, double plateau, double phase);
  [[nodiscard]] double largest_of_path(Corner const& corner, double plateau, double phase) const;

  GroupRuntime* runtime_;
  double reach_ = 0;  ///< plateau_cycles(), whole
  double delay_ = 0;
  std::vector<Point> path_;  ///< filtered, from cycle -reach_ on, the delay taken off
};

}  // namespace axisc::motion
