// B2: what a second-order section passes on, and what its states still hold, over all cycles.
#pragma once

#include <stdint.h>

namespace axisc::runtime::bounds {

/// The longest walk of a section; a slower one has bounds that are true and far from tight.
inline constexpr uint32_t longest_walk = 1U << 21U;

/// Left alone, the states (e, r) of a section move by
///     e' = e + r,   r' = r - b r - k e',   (e, r)' = A (e, r),   A = [[1, 1], [-k, 1 - k - b]].
struct SectionBound {
  double p, g, k, b;  ///< as stored; g = p + q
  double lost_of_g;   ///< what rounding took from it

  /// Upper bounds of the sum of |A^n| over n = 0, 1, ..., element by element.
  double ee, er, re, rr;
  double change;  ///< of the sum of |r[n+1] - r[n]| from the state (0, 1)
  /// Upper bounds for every unit of the sum of |d| that enters.
  double excess;     ///< sum of |e|
  double following;  ///< sum of |r|: that of |de| is |p| more
  double passed;     ///< sum of |d| that leaves it

  /// In this many cycles the scaled states, (s e, r) with s near the square root of k, shrink to 2^-23 of
  /// what they were, their roundings included; 0 where that is not certain.
  uint32_t shrinking;
  double scale;   ///< s, a power of two
  double radius;  ///< no pole is farther from 0
};

/// Walks with three states, until A^m is small: at most longest_walk cycles, of some ns each.
[[nodiscard]] SectionBound bound_section(double p, double q, double k, double b, bool blocks_constant);

}  // namespace axisc::runtime::bounds
