// The figures of a circular test in tables.
#pragma once

#include "axisc/answers/circle/circular_test.hpp"
#include "presentation/document.hpp"

namespace axisc::says {

// Causes that tables and sentences name alike.
inline constexpr Sentence radius{"radius", "Radius"};
inline constexpr Sentence delay{"delay {u} - {v}", "Verzögerung {u} - {v}"};
inline constexpr Sentence backlash{"backlash {axis}", "Lose {axis}"};

}  // namespace axisc::says

namespace axisc {

/// Of a share: µm/m; of seconds: µs.
inline constexpr double millionths = 1e6;

// For people: predicted, and beside it what was recorded.

[[nodiscard]] presentation::Table deviations_table(CircleCase const& one);
/// Without backlash and reversals where they cannot be told apart.
[[nodiscard]] presentation::Table causes_table(CircleCase const& one);

/// What each filter adds to radius and delay.
[[nodiscard]] presentation::Table filters_table(CircleCase const& one);

}  // namespace axisc
