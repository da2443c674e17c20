// The largest swing of a mass on a spring whose frequency and damping are known only within limits.
//
// Velocity jumps a[n] make it swing by  |x| = |q| / (ω_d T),  where q[n] = e^s q[n-1] + a[n]  and
// s = (-D ω + j ω_d) T  (see excitation.hpp): q is a polynomial in e^s, and ω_d T the imaginary part of s.
// The logarithms of |q| and of 1 / Im s are subharmonic functions of s, hence the logarithm of the swing is
// one, and so is that of its largest value over cycles: over a region of frequencies and dampings it is
// largest on the edge. The edge has four parts: the lowest and the highest damping (rays from s = 0), the
// lowest and the highest frequency (arcs around it).
//
// Along a part, for |δ| ≤ h and with q' = dq/ds,
//     |q(s + δ)| ≤ |q + q' ds| + |q'| |s''| h²/2 + max|q''| |ds|²/2.
// The first term is convex and Im s is concave, so that their quotient is largest at the ends of an interval.
// Intervals are halved until none of them can hold more than what was found.
#pragma once

#include <cstddef>
#include <vector>

namespace axisc::tuning {

/// The cause of the swing, a value a cycle, and the cycle from which on the swing counts.
struct Drive {
  std::vector<double> jumps;
  std::size_t rest = 0;
};

/// Frequencies in rad per cycle, undamped; damping ratios.
struct SwingBand {
  double lowest = 0, highest = 0;
  double least_damping = 0, most_damping = 0;
};

/// The largest at sixteen places of the band: at most the largest of all, at a 10th of the cost.
[[nodiscard]] double swing_at_least(Drive const& drive, SwingBand const& band);

/// At one frequency and damping; the unit is that of the jumps.
[[nodiscard]] double swing(Drive const& drive, double frequency, double damping);

/// Over the whole band: the returned swing occurs there, and nothing in the band is larger than it by more
/// than a 10,000th of it and `negligible`. Cost: some 30 passes over the jumps, eight points each.
[[nodiscard]] double largest_swing(Drive const& drive, SwingBand const& band, double negligible);

}  // namespace axisc::tuning
