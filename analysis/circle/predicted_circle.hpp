// What the filters of two axes make of a circle.
//
// With the angular speed ω = v/R, the gains A = |H_u|, B = |H_v| and the phase delays τ_u, τ_v at ω,
// δ = ω (τ_u - τ_v) and s = +1 counterclockwise, -1 clockwise, the path is an ellipse,
//
//     u = A R cos(ψ - δ/2),  v = s B R sin(ψ + δ/2),
//
// whose semi-axes are R times the singular values of the matrix of (cos ψ, sin ψ). In first order
//
//     ρ = R ((A + B)/2 - 1) + R (A - B)/2 cos 2θ + s (R/2) sin δ sin 2θ:  radius, gain, delay.
#pragma once

#include "analysis/circle/deviations.hpp"

namespace axisc::circle {

struct PredictedCircle {
  double radius = 0;              ///< R, µm
  double gain_u = 1, gain_v = 1;  ///< A, B
  double phase = 0;               ///< δ, rad

  /// Distance from the centre - R, at this angle from u to v.
  [[nodiscard]] double deviation_at(double angle, Sense sense) const;
  /// G and G(b) are the difference of the semi-axes, F is the semi-axes - R, D the mean radius over the
  /// angle - R.
  [[nodiscard]] Deviations deviations() const;
  /// A - B.
  [[nodiscard]] double gain_difference() const { return gain_u - gain_v; }
  /// R ((A + B)/2 - 1).
  [[nodiscard]] double radius_deviation() const { return radius * ((gain_u - 1) + (gain_v - 1)) / 2; }
};

}  // namespace axisc::circle
