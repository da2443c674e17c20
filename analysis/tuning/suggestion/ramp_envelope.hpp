// How much less a ramp with limited jerk excites a resonance than one with STEP.
//
// The acceleration of STEP jumps by a where a ramp begins and where it ends. A slope spreads each of these
// jumps over a ramp time tr, and what it excites at a frequency f shrinks by, with x = π f tr,
//     TRAPEZ  |sin x / x|,    sin²  |cos x / (1 - (2x/π)²)|,
// the magnitude of the Fourier transform of a'(t), scaled to an integral of 1.
#pragma once

#include "analysis/motion/planning/ramp.hpp"

namespace axisc::tuning {

[[nodiscard]] double trapez_envelope(double x);
[[nodiscard]] double sine_envelope(double x);

/// The most that a change between rest and a velocity excites, as a share of the most with STEP and the same
/// acceleration: half of what both ends of the change leave. 1 for STEP. `frequency` in rad per cycle; of a
/// change too small for the acceleration the ramps that it has.
[[nodiscard]] double envelope(motion::Ramp const& ramp, double velocity, double frequency);

}  // namespace axisc::tuning
