// The path velocity at which an axis error becomes as large as a tolerance.
#pragma once

#include "analysis/motion/contour/contour_predictions.hpp"

#include <optional>
#include <span>
#include <vector>

namespace axisc::motion {

/// Highest velocity in units per cycle at which the axis error at a corner keeps `tolerance` (units); none
/// where any velocity does. The error is proportional to the velocity.
[[nodiscard]] std::optional<double> corner_velocity(std::span<ChainAnswer const> answers, double turn,
                                                    double tolerance);

/// How fast circles may be passed. The error need not grow with the velocity: with a kernel of flat gain it
/// falls and rises again. The first velocity at which it exceeds the tolerance counts.
class CircleVelocities {
 public:
  /// The answers must outlive this.
  explicit CircleVelocities(std::span<ChainAnswer const> answers);

  /// Highest velocity on a circle up to which every velocity keeps the tolerance; none where any does up to
  /// half a turn per cycle, beyond which setpoints describe no circle. Cost: some dozen predictions, and once
  /// as many as eight times the cycles of the kernels.
  [[nodiscard]] std::optional<double> highest(double radius, double tolerance);

 private:
  /// The error on a circle of radius 1 that turns by so much per cycle.
  [[nodiscard]] double error(double angle) const;
  void look_further();

  std::span<ChainAnswer const> answers_;
  double step_ = 0;
  double most_ = 0;              ///< that an error can be
  std::vector<double> errors_;   ///< at whole steps
  std::vector<double> highest_;  ///< up to each of them
};

/// The highest velocity on one circle.
[[nodiscard]] std::optional<double> circle_velocity(std::span<ChainAnswer const> answers, double radius,
                                                    double tolerance);

}  // namespace axisc::motion
