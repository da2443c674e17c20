// Readings of a standard filter.
#pragma once

#include "analysis/comparison/readings.hpp"

#include <optional>
#include <span>

namespace axisc::comparison {

struct FilterReading {
  Departure departure;
  /// None where it changes nothing about that type, or where it would be unstable.
  std::optional<Link> (*link)(design::FilterSpecification const& wanted, design::CycleTime cycle_time);
};

[[nodiscard]] std::span<FilterReading const> filter_readings();

}  // namespace axisc::comparison
