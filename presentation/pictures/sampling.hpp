// Points of a curve: few where it is straight, many where it bends, and exactly those that must not be
// missed.
#pragma once

#include "presentation/pictures/figure.hpp"

#include <functional>
#include <span>
#include <vector>

namespace axisc::pictures {

/// Largest distance between a drawn curve and the function, in pixels.
inline constexpr double largest_error = 0.1;

/// Points of `function` from x.low to x.high so that the line between them, drawn in a panel with the axes x
/// and y, is nowhere farther than largest_error from it in vertical direction; jumps are bracketed to a
/// hundredth of a pixel. All of `exact` that are in range are among them. Cost: a few hundred to some
/// thousand calls.
[[nodiscard]] std::vector<Point> sample(Axis const& x, Axis const& y, std::span<double const> exact,
                                        std::function<double(double)> const& function);

}  // namespace axisc::pictures
