// How much sections pass on of what they are given, and of what their states hold: upper bounds of sums over all cycles.
// All are for increments, whose sum of magnitudes behind a chain is the peak gain of a unit impulse.
#pragma once

#include "design/filter_design.hpp"

#include <vector>

namespace axisc::design {

/// Of a section, for every unit of Σ|d| before it or of its states (e, r) when it is left alone.
struct SectionGain {
  double passed = 1;    ///< Σ|d| behind it
  double per_e = 0;     ///< Σ|de| that is still to come of e
  double per_r = 0;     ///< and of r
  double rounding = 0;  ///< Σ|d| behind it that rounding adds to a run in double, at most
};

/// Of a filter, its share included.
struct FilterGain {
  std::vector<SectionGain> sections{};
  double passed = 1;
  double rounding = 0;
};

/// Infinite for a section whose poles are closer to the unit circle than AX6001 allows, by far: rounding could hide then that it
/// does not settle. Cost: about 3 ns per cycle in which the slowest pole shrinks to a sixteenth, at most 10 ms.
[[nodiscard]] FilterGain filter_gain(FilterDesign const& filter);

}  // namespace axisc::design
