// The oscillation in which an axis comes to rest: a pole of its closed loop, which the setpoint excites.
//
// After a motion the setpoint rests, and each signal r follows
//
//     y_r(t) = c_r + d_r1 e^(-t/τ1) + d_r2 e^(-t/τ2) + e^(-D ω0 t) (a_r cos ω_d t + b_r sin ω_d t),
//     ω0 = 2π f,  ω_d = ω0 √(1 - D²).
//
// f, D, τ1 and τ2 are common to all rests; c, d, a and b of each follow from them by linear least squares:
// variable projection (Golub and Pereyra 1973).
#pragma once

#include "analysis/tuning/identification/motion_pieces.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace axisc::tuning {

struct RingDown {
  double frequency = 0;  ///< natural, Hz
  double frequency_uncertainty = 0;
  double damping = 0;
  double damping_uncertainty = 0;
};

/// By the thresholds of thresholds.hpp.
enum class RingDownDoubt : std::uint8_t {
  few_rests,        ///< after a motion
  no_oscillation,   ///< the sine explains too little, or the oscillation is damped too well to be one
  few_periods,      ///< in a rest
  keeps_on,         ///< something shakes the axis at rest
  halves_disagree,  ///< about the frequency
};

struct BadRingDown {
  RingDownDoubt doubt = RingDownDoubt::few_rests;
  double frequency = 0;  ///< Hz, of what was not believed; 0: none
};

/// Searches below `highest` Hz. Of many rests the first 40 count, of each at most a second. Cost: some
/// hundred passes over them.
[[nodiscard]] std::variant<RingDown, BadRingDown> ring_down(std::span<SteadySignal const> rests,
                                                            double highest);

}  // namespace axisc::tuning
