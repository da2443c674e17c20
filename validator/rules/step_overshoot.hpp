// How far a filter's step response exceeds its final value, for the rules about overshoot.
#pragma once

#include "validator/engine/rule.hpp"

#include <optional>

namespace axisc::validator::checks {

/// Largest excess of the filter's step response above its final value, as a share of the final value; none
/// where the filter is not active or a value is out of range. For types with a characteristic frequency;
/// their highest excess falls into the first periods. Far below the sampling rate a step response depends on
/// time and frequency only through their product, so a very slow filter is measured by a faster one. Cost: at
/// most 20,000 cycles.
[[nodiscard]] std::optional<double> step_overshoot(FilterContext const& context);
/// The overshoot of a filter that no list configures.
[[nodiscard]] double step_overshoot(design::FilterSpecification specification, design::CycleTime cycle_time);

/// The label of a finding that states the overshoot.
[[nodiscard]] Message overshoot_label(double overshoot);

}  // namespace axisc::validator::checks
