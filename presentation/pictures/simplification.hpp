// Fewer points for the same line.
#pragma once

#include "presentation/pictures/figure.hpp"

#include <vector>

namespace axisc::pictures {

/// Points without those that lie within `tolerance`, measured upwards, of the line between the neighbours
/// that are left. A curve whose abscissas do not rise strictly is unchanged; so are its interruptions.
[[nodiscard]] std::vector<Point> simplified(std::vector<Point> const& points, double tolerance);

}  // namespace axisc::pictures
