// The frequencies of `axisc response`.
#pragma once

#include "design/units.hpp"

#include <string>
#include <vector>

namespace axisc {

/// "0,1,2.5" in Hz. Failure for anything that is not a number from 0 to 0.5/T.
[[nodiscard]] std::vector<double> parse_frequencies(std::string const& text, design::CycleTime cycle_time);

/// 200 points at equal ratios, four decades up to 0.5/T; the last one is 0.5/T exactly. Among them those of
/// `characteristic` that are below 0.5/T, so that a notch is not missed.
[[nodiscard]] std::vector<double> default_frequencies(design::CycleTime cycle_time,
                                                      std::vector<double> const& characteristic);

}  // namespace axisc
