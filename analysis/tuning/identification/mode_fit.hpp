// Natural frequency and damping ratio of the mode behind a peak.
//
// With phase, by Levy's linear least squares over the points around the peak,
//     a0 H + a1 jω H - b0 - b1 jω = ω² H,  a0 = ω0², a1 = 2 D ω0,  b0, b1 complex;
// with magnitudes alone  1/|H|² = p2 ω⁴ + p1 ω² + p0  of a single mode.
#pragma once

#include "analysis/tuning/identification/measured_response.hpp"

#include <cstddef>

namespace axisc::tuning {

struct Mode {
  double frequency = 0;  ///< Hz
  double damping = 0;
};

/// `top` is the place of a local maximum. Where no mode fits, the maximum and its half-power band.
[[nodiscard]] Mode fit_mode(MeasuredResponse const& measured, std::size_t top);

}  // namespace axisc::tuning
