// The figures of a circular test in tables.
#pragma once

#include "axisc/answers/circle/circular_test.hpp"
#include "presentation/document.hpp"

namespace axisc {

// For people: predicted, and beside it what was recorded.

[[nodiscard]] presentation::Table deviations_table(CircleCase const& one);
/// Without backlash and reversals where they cannot be told apart.
[[nodiscard]] presentation::Table causes_table(CircleCase const& one);

/// What each filter adds to radius and delay.
[[nodiscard]] presentation::Table filters_table(CircleCase const& one);

}  // namespace axisc
