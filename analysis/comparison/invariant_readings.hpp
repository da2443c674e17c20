// Readings of a standard filter as taps: discretisations that keep the analogue answer to an impulse or a
// step. Settings do not offer them: no cascade of sections computes them.
#pragma once

#include "analysis/comparison/filter_readings.hpp"

#include <span>

namespace axisc::comparison {

[[nodiscard]] std::span<FilterReading const> invariant_readings();

}  // namespace axisc::comparison
