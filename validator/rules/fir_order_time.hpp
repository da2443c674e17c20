// The order of a FIR filter, given as a time.
#pragma once

#include "design/units.hpp"
#include "diagnostics/finding.hpp"
#include "validator/views/fir_view.hpp"

namespace axisc::validator::checks {

/// order_time decides the order: a list gives it, and no order.
[[nodiscard]] bool uses_order_time(FirView const& fir);

/// Less than one cycle, or more cycles than the longest order: nothing is rounded then.
[[nodiscard]] bool is_too_short(FirView const& fir, design::CycleTime cycle_time);
[[nodiscard]] bool is_too_long(FirView const& fir, design::CycleTime cycle_time);

}  // namespace axisc::validator::checks
