// Rotary axes whose position jumps by a full turn.
#pragma once

#include "analysis/comparison/verdict.hpp"

#include <cstddef>

namespace axisc::comparison {

/// Makes both columns continuous: where a value is more than half a turn from the one before, it and all
/// later ones move by turns. Interpolated values of lost cycles are computed again. Returns the number of
/// jumps.
std::size_t unwind(Recording& recording, double turn);
/// One column alone.
std::size_t unwind(Signal& signal, std::vector<std::size_t> const& gaps, double turn);

}  // namespace axisc::comparison
