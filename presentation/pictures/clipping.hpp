// Curves cut at the edge of a panel.
#pragma once

#include "presentation/pictures/figure.hpp"

#include <vector>

namespace axisc::pictures {

/// The parts of a curve inside both ranges, interrupted where it is outside.
[[nodiscard]] std::vector<Point> clipped(std::vector<Point> const& points, Axis const& x, Axis const& y);

}  // namespace axisc::pictures
