// The delay budget of an axis in sentences: for the answer, the report and the editor.
#pragma once

#include "presentation/value.hpp"
#include "validator/views/delay_budget.hpp"

#include <vector>

namespace axisc {

/// What arrives when, which part of it is the lag, and how far a lead takes the axis: a sentence each. None
/// where nothing delays.
[[nodiscard]] std::vector<presentation::Words> delay_words(validator::LoadedAxis const& axis,
                                                           validator::DelayBudget const& budget,
                                                           design::CycleTime cycle_time);

/// Cycles as milliseconds.
[[nodiscard]] presentation::Quantity delay_time(double cycles, design::CycleTime cycle_time);

/// Sums of the same delays in another order differ by less, in cycles.
inline constexpr double delay_rounding = 1e-9;

}  // namespace axisc
