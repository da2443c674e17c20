// The best of the candidates, in three senses.
#pragma once

#include "analysis/tuning/suggestion/candidates.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace axisc::tuning {

enum class Sense : std::uint8_t { least_deviation, balanced, least_vibration };
inline constexpr std::size_t senses = 3;

/// A quarter of the vibration may remain; where the control can do less, hardly more than the least, and in
/// no case more than half of it.
inline constexpr double sufficient_vibration = 0.25;
inline constexpr double useful_vibration = 0.5;

struct Choice {
  std::array<Candidate, senses> chosen;  ///< by Sense
  Sense recommended = Sense::balanced;   ///< by the task's goal
  /// Weighs less than the balanced one, but overshoots or is no longer advised, so that lists that set it
  /// have findings.
  std::optional<Candidate> not_clean = std::nullopt;
};

/// Deviation times remaining vibration, in the sense of Klipper's input shaper calibration: p (v^1.5 + 0.2 v
/// + 0.01). The price p is the corner's deviation, or the delay where speed is the goal.
[[nodiscard]] double balance(Figures const& figures, std::optional<Goal> goal);

/// None where every candidate leaves more than useful_vibration. The figures of candidates are lower
/// bounds, and every price rises with them: those that may be the best are settled, cheapest estimate first,
/// until no estimate is below the best settled one. So the best is as certain as if all were settled.
[[nodiscard]] std::optional<Choice> choose(std::span<Candidate> candidates, Judge const& judge,
                                           std::optional<Goal> goal);

/// The vibration that the calmest clean candidate leaves; 1 where there is none.
[[nodiscard]] double least_vibration(std::span<Candidate> candidates, Judge const& judge);

}  // namespace axisc::tuning
