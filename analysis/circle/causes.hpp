// What bends a recorded circle: weighted least squares over the turns, θ the angle of the actual position,
// s = +1 counterclockwise, -1 clockwise, 1° before and 10° after each reversal of an axis left out:
//
//     ρ = r0 + a cos θ + b sin θ + g cos 2θ + q sin 2θ + s d sin 2θ
//         + s (B_u/2) sgn(sin θ) cos θ - s (B_v/2) sgn(cos θ) sin θ
//
//   gain difference   2 g / R                            squareness   -2 q / R
//   delay difference  τ_u - τ_v = asin(2 d / R) / ω      backlash     B: the axis is B/2 behind both ways
//
// Friction makes spikes after reversals, which the windows leave out as far as they decay within them. Where
// a window of 25° changes a backlash by more than 0.3 µm, they do not: then neither is known.
#pragma once

#include "analysis/circle/turn.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace axisc::circle {

struct Causes {
  double radius = 0;                             ///< r0, µm
  std::array<double, 2> centre{};                ///< a, b, µm
  double gain_difference = 0;                    ///< of u - of v
  double squareness = 0;                         ///< rad: how far the axes' angle is from 90°
  double delay_difference = 0;                   ///< τ_u - τ_v, rad: times 1/ω is a time
  std::array<double, 2> backlash{};              ///< µm
  std::array<double, 2> backlash_uncertainty{};  ///< by how much the wider window changes it
  bool is_separable = true;                      ///< backlash and friction can be told apart
  /// Largest residual within 20° after a reversal, µm: counterclockwise at u+, v+, u-, v-, then clockwise.
  std::array<double, 8> spikes{};
  double unexplained_rms = 0;  ///< µm, outside the windows

  /// Of the four of an axis, 0 for u, 1 for v.
  [[nodiscard]] double largest_spike(std::size_t axis) const;
};

/// Of two turns in different directions; `radius` is R in µm. None where the turns do not decide.
[[nodiscard]] std::optional<Causes> causes_of(std::span<Turn const> turns, double radius);

}  // namespace axisc::circle
