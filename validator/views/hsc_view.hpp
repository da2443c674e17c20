// An HSC filter as a linear-phase kernel: prototype HSC in filter[i], types HSC_MEAN and HSC_SHAPER (NoVib).
#pragma once

#include "design/filter_kinds.hpp"
#include "design/kernels/kernel_design.hpp"
#include "validator/views/filter_view.hpp"

#include <optional>
#include <span>
#include <vector>

namespace axisc::validator {

using design::HscType;

/// A filter[i] with prototype HSC: configured, whatever its type.
[[nodiscard]] bool is_configured_hsc(FilterView const& filter);

/// Every configured HSC filter, in order of i; the control accepts one, in filter[0].
[[nodiscard]] std::vector<FilterView> configured_hsc(EffectiveValues const& values);
/// The configured HSC filters among the result of touched_filters().
[[nodiscard]] std::vector<FilterView> configured_hsc(std::span<FilterView const> filters);

/// The HSC type of a filter; none if it cannot be used or is not an HSC type, and for everything that is not
/// a configured HSC filter.
[[nodiscard]] std::optional<HscType> hsc_type(FilterView const& filter);

/// The order of an HSC filter; for the mean, if order is 0, the order that time_constant gives (by default
/// 10000 µs); 0 if there is none: time_constant < T, and NoVib without an order.
[[nodiscard]] double resulting_hsc_order(FilterView const& filter, design::CycleTime cycle_time);

/// The kernel of an HSC filter; NoVib has the default order, because it computes its own. None if a value is
/// out of range, or if NoVib has no order and is therefore never active.
[[nodiscard]] std::optional<design::KernelSpecification> hsc_kernel(FilterView const& filter,
                                                                    design::CycleTime cycle_time);

}  // namespace axisc::validator
