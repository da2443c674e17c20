// Readings of a standard filter that settings do not have: other analogue filters, and discretisations by their answers.
#pragma once

#include "comparison/filter_readings.hpp"

#include <span>

namespace axisc::comparison {

[[nodiscard]] std::span<FilterReading const> analogue_readings();

}  // namespace axisc::comparison
