// Positions of the axes of one path. Components that a path has not are 0.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace axisc::motion {

/// More axes than a path of an NC channel moves at once.
inline constexpr std::size_t most_axes = 8;

/// Position units of the lists (0.1 µm or 1e-4°) in a millimetre or degree.
inline constexpr double units_per_mm = 1e4;
/// Position units in a micrometre or 1e-3°.
inline constexpr double units_per_um = 10;
inline constexpr double um_per_mm = units_per_mm / units_per_um;

/// One number per axis of the path.
using Point = std::array<double, most_axes>;

[[nodiscard]] inline Point plus(Point a, double factor, Point const& b) {
  for (std::size_t i = 0; i < most_axes; ++i) a[i] += factor * b[i];
  return a;
}

[[nodiscard]] inline Point minus(Point a, Point const& b) {
  for (std::size_t i = 0; i < most_axes; ++i) a[i] -= b[i];
  return a;
}

[[nodiscard]] inline double dot(Point const& a, Point const& b) {
  double sum = 0;
  for (std::size_t i = 0; i < most_axes; ++i) sum += a[i] * b[i];
  return sum;
}

[[nodiscard]] inline double length(Point const& a) {
  return std::sqrt(dot(a, a));
}

}  // namespace axisc::motion
