// What delays the positions of a path's axes after their filters, as far as it differs: a common delay shifts
// the path in time and bends nothing.
#pragma once

#include "analysis/motion/point.hpp"
#include "configuration/machine/machine.hpp"

#include <cstddef>
#include <vector>

namespace axisc::motion {

/// Without what all axes have in common; none where they differ in nothing.
[[nodiscard]] std::vector<machine::PositionDelay> unequal_delays(
    std::vector<machine::PositionDelay> const& delays);

class PositionDelays {
 public:
  /// Nothing is delayed.
  PositionDelays() = default;
  /// One for each axis of the path, as unequal_delays() leaves them.
  explicit PositionDelays(std::vector<machine::PositionDelay> const& unequal);

  /// Every axis rests at `position`.
  void reset(Point const& position);
  /// One NC cycle: from filtered setpoints to what the position controllers get.
  void step(Point& position);

 private:
  struct Axis {
    std::vector<double> waiting;  ///< a ring: one place for each whole cycle
    std::size_t oldest = 0;
    double share = 1;  ///< of what is missing, that a cycle adds: 1/(1 + τ/T), whose delay is τ/T exactly
    double value = 0;
  };

  std::vector<Axis> axes_;  ///< none where all are delayed alike
};

}  // namespace axisc::motion
