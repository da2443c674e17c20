// The path velocity at which an axis error becomes as large as a tolerance.
#pragma once

#include "motion/contour/contour_predictions.hpp"

#include <optional>

namespace axisc::motion {

/// Highest velocity in units per cycle at which the axis error at a corner keeps `tolerance` (units); none where any
/// velocity does. The error is proportional to the velocity.
[[nodiscard]] std::optional<double> corner_velocity(std::span<ChainAnswer const> answers, double turn,
                                                    double tolerance);

/// Highest velocity on a circle up to which every velocity keeps the tolerance; the error need not grow with it. None
/// where any does up to half a turn per cycle, beyond which setpoints describe no circle. Cost: some thousand predictions
/// where the tolerance is never exceeded.
[[nodiscard]] std::optional<double> circle_velocity(std::span<ChainAnswer const> answers, double radius,
                                                    double tolerance);

}  // namespace axisc::motion
