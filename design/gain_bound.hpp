// How much of their input, and of the content of their states, sections pass on: upper bounds of sums over
// all cycles. All are for increments, whose sum of magnitudes after a chain is the peak gain of a unit
// impulse.
#pragma once

#include "design/filter_design.hpp"

#include <vector>

namespace axisc::design {

/// Bounds of a section, for every unit of Σ|d| before it, or of its states (e, r) without input.
struct SectionGain {
  double passed = 1;    ///< Σ|d| after it
  double per_e = 0;     ///< Σ|de| that is still to come from e
  double per_r = 0;     ///< and from r
  double rounding = 0;  ///< Σ|d| after it that rounding adds to a run in double, at most
};

/// The bounds of a filter, its share included.
struct FilterGain {
  std::vector<SectionGain> sections{};
  double passed = 1;
  double rounding = 0;
};

/// Infinite for a section whose poles are far closer to the unit circle than AX6001 allows: rounding could
/// then hide that it does not settle. Cost: about 3 ns per cycle in which the slowest pole shrinks to a
/// sixteenth, at most 10 ms.
[[nodiscard]] FilterGain filter_gain(FilterDesign const& filter);

}  // namespace axisc::design
