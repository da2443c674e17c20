// The older filter of the additional interface: one time constant, without a type.
#pragma once

#include "design/filter_specification.hpp"
#include "validator/values/effective_values.hpp"

#include <optional>
#include <string_view>

namespace axisc::validator {

inline constexpr std::string_view interface_filter_time_name = "kenngr.in_add_interface_filter_time";

/// P-AXIS-00438 as the PT2 that it is; none where it is 0, unusable, or shorter than a cycle.
[[nodiscard]] std::optional<design::FilterSpecification> interface_filter_time(EffectiveValues const& values,
                                                                               design::CycleTime cycle_time);

}  // namespace axisc::validator
