// The circle that fits positions best.
#pragma once

#include "analysis/circle/turn.hpp"

#include <span>

namespace axisc::circle {

struct FittedCircle {
  double u = 0, v = 0, radius = 0;  ///< µm
};

/// Geometric least squares, Σ w (|p - c| - r)² → min: the circle of ISO 230-4's least squares centre. At
/// least three positions that are not on a line; else the result is not finite. Cost: some passes.
[[nodiscard]] FittedCircle fit_circle(std::span<Sample const> samples);

}  // namespace axisc::circle
