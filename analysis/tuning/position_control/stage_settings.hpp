// Every stage of Improved Position Control that could damp a resonance.
//
// Modes DIRECT, INDIRECT and SET_POINT; band-passes of order 1 to 3 and quality 1, 2, 5 and 10 at 0.9, 0.95,
// 1, 1.05 and 1.1 times the resonance; oscillators with a damping of 0.2, 0.4 and 0.8; weights from 0.11 to
// 7, each √2 times the one before. INDIRECT and SET_POINT only where their dead time shifts the phase by 45°
// at most (AX3036).
#pragma once

#include "configuration/machine/machine.hpp"
#include "design/units.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace axisc::tuning {

/// Numerators of the weights; all have the same denominator.
inline constexpr std::array<double, 13> weight_numerators = {110,  155,  220,  310,  440,  620, 875,
                                                             1240, 1750, 2475, 3500, 4950, 7000};
inline constexpr double weight_denominator = 1000;

/// stage[index] with each combination except the weight, in an order of its own.
[[nodiscard]] std::vector<machine::PositionControlStage> stages_for(double frequency, std::uint32_t index,
                                                                    design::CycleTime cycle_time);

/// The bands of two stages do not overlap: |f1 - f2| ≥ f1/(2 q1) + f2/(2 q2)  (AX3034).
[[nodiscard]] bool are_apart(machine::PositionControlStage const& one,
                             machine::PositionControlStage const& other);

}  // namespace axisc::tuning
