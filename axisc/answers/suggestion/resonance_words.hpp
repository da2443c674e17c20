// `--resonance`.
#pragma once

#include "analysis/tuning/suggestion/task.hpp"
#include "design/units.hpp"

#include <string>
#include <vector>

namespace axisc {

/// "48Hz", "48:0.03,112Hz": frequencies, each perhaps with its damping ratio; one to three. Failure for
/// anything else, and for a frequency that is not below 0.5/T.
[[nodiscard]] std::vector<tuning::Resonance> read_resonances(std::string const& words,
                                                             design::CycleTime cycle_time);

inline constexpr std::size_t most_resonances = 3;

}  // namespace axisc
