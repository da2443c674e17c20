// What the filters of two axes make of a circle: an ellipse.
#pragma once

#include "analysis/motion/point.hpp"

#include <array>
#include <cmath>
#include <complex>

namespace axisc::motion {

/// Setpoints r cos ψ and r sin ψ come out as the real part of x e^(jψ) and the imaginary part of y e^(jψ).
struct FilteredCircle {
  std::complex<double> x, y;

  /// For a setpoint on the circle of radius 1.
  [[nodiscard]] Point at(std::complex<double> setpoint) const {
    Point point{};
    point[0] = (x * setpoint).real();
    point[1] = (y * setpoint).imag();
    return point;
  }
  /// (|x + y| + |x - y|) / 2  and  ||x + y| - |x - y|| / 2,  the larger one first: the path is the sum of two
  /// circles in opposite directions,  u + jv = e^(jψ) (x + y)/2 + e^(-jψ) conj(x - y)/2.
  [[nodiscard]] std::array<double, 2> semi_axes() const {
    double const sum = std::abs(x + y);
    double const difference = std::abs(x - y);
    return {(sum + difference) / 2, std::abs(sum - difference) / 2};
  }
};

}  // namespace axisc::motion
