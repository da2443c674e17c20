// Tolerance monitoring (AX_DEV): how fast corners and curvature may be passed.
//
// With path velocity v in units per cycle and the directions' changes Δu_m at the distances d_m from a corner, axis i is
//     E_i = v Σ_m Δu_m,i R_i(d_m / v)
// away from its setpoint at that corner (chain_answer.hpp). The velocity is the first at which some |E_i| reaches the
// tolerance, rising from 0. It holds on a plateau of h cycles to either side (corner_probe.hpp). Beside the corner an axis may
// be a little further away than at it, because the ramps shift the path along the blocks and because it is straight
// from one cycle to the next: how much, the probe measures, and the tolerance is reached with that.
#pragma once

#include "motion/corner_probe.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace axisc::motion {

class ToleranceMonitor {
 public:
  /// Monitors nothing.
  ToleranceMonitor() = default;
  /// `tolerance` in units; 0: no monitoring. Runtime and answers live longer.
  ToleranceMonitor(GroupRuntime& probe, std::vector<ChainAnswer> const& answers, double tolerance);

  [[nodiscard]] bool active() const { return probe_.has_value() && tolerance_ > 0; }
  /// Cycles on either side of a corner.
  [[nodiscard]] double plateau() const { return plateau_cycles(answers_); }
  /// Velocity for corners[index], or infinite where the fastest of its blocks keeps the tolerance. Corners further away
  /// than most_neighbours are not looked at. Cost: for a corner that stands alone and has to be slower some 0.3 ms, unless
  /// one like it was seen lately.
  [[nodiscard]] double velocity(std::span<Corner const> corners, std::size_t index);

  static constexpr std::size_t most_neighbours = 128;

 private:
  /// What was measured at a corner like this one.
  struct Known {
    Corner corner;
    double enlarged = 1;
  };

  /// How much larger the error around a corner alone is than at the corner, where it reaches the tolerance.
  [[nodiscard]] double enlarged(Corner const& corner);
  /// At one unit per cycle:  max |Δu_i| R_i(0).
  [[nodiscard]] double at_corner(Corner const& corner) const;
  [[nodiscard]] double largest_error(std::span<Corner const> near, std::size_t index, double velocity) const;

  std::optional<CornerProbe> probe_;
  std::span<ChainAnswer const> answers_;
  double tolerance_ = 0;
  double reach_ = 0;
  std::vector<Known> known_;
  std::size_t replaced_ = 0;
};

}  // namespace axisc::motion
