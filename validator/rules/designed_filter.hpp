// Filters as the rules look at them after design, in double.
#pragma once

#include "design/filter_design.hpp"
#include "validator/filter_view.hpp"

#include <optional>
#include <vector>

namespace axisc::validator::checks {

/// The filter designed; none where it is not active or a value is out of range.
[[nodiscard]] std::optional<design::FilterDesign> designed(FilterView const& filter,
                                                           design::CycleTime cycle_time);

/// Largest excess of the filter's step response above its final value, as a share of the final value; none
/// as above. For types with a characteristic frequency; their highest excess falls into the first periods.
/// Far below the sampling rate a step response depends on time and frequency only through their product, so
/// a very slow filter is measured by a faster one. Cost: at most 20,000 cycles.
[[nodiscard]] std::optional<double> step_overshoot(FilterView const& filter, design::CycleTime cycle_time);

/// An active filter[i] of an axis, through which some of the signal passes, with its design.
struct ChainLink {
  FilterView filter;
  design::FilterDesign design;
};

/// The chain that the setpoint passes; empty where no filter is active, or where one of them cannot be
/// designed, so that nothing is said about a chain that is not the real one.
[[nodiscard]] std::vector<ChainLink> setpoint_chain(EffectiveValues const& values,
                                                    design::CycleTime cycle_time);
[[nodiscard]] std::vector<design::FilterDesign> designs(std::vector<ChainLink> const& chain);

}  // namespace axisc::validator::checks
