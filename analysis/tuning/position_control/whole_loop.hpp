// The move of a loop task with everything that acts in the loop: teeth, limit, filters, the way back and the
// rest after it.
#pragma once

#include "analysis/tuning/position_control/damping_search.hpp"

#include <span>

namespace axisc::tuning {

/// P-AXIS-00757 in 0.1 %: all of the axis' velocity.
inline constexpr double whole_velocity = 1000;

/// Twice the weights, 7 at most.
[[nodiscard]] machine::PositionControl with_doubled_weights(machine::PositionControl control);

/// The loop diverges with none of the plants, not even with doubled weights.
[[nodiscard]] bool keeps_margin(LoopTask const& task, std::span<motion::PlantParameters const> plants,
                                machine::PositionControl const& control);

/// P-AXIS-00757 for twice the largest additive velocity of the move with whichever plant: only a loop that
/// goes wrong reaches it.
[[nodiscard]] double limit_for(LoopTask const& task, std::span<motion::PlantParameters const> plants,
                               machine::PositionControl const& control);

/// Fills in the figures of `found.control` from the move; the first plant is the axis' own.
void measure(LoopTask const& task, std::span<motion::PlantParameters const> plants, Damping& found);

}  // namespace axisc::tuning
