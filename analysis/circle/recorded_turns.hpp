// The turns of a recording that count: of each direction the last 360° at constant speed.
//
// A sample counts where the setpoint's speed over 20 ms is within 1 % of its median over all that moves, and
// where the setpoint is on the circle, within R/500, on which most such samples lie: straight lines and arcs
// that lead to the circle and away from it do not. Where the path leaves the circle, so much is cut off that
// it had not begun to: an arc is seen late that leaves it tangentially.
#pragma once

#include "analysis/circle/turn.hpp"

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

namespace axisc::circle {

struct RecordedPath {
  std::vector<double> setpoint_u, setpoint_v;  ///< µm; empty: not recorded
  std::vector<double> actual_u, actual_v;      ///< µm, as many
  std::vector<std::size_t> gaps;               ///< samples that were lost and are interpolated, rising
  double sample_time = 0;                      ///< s
  double settling = 0;                         ///< s, until filters have forgotten how the circle began
  double resolution = 0;                       ///< µm, of the positions
};

inline constexpr std::size_t fewest_points = 120;  ///< of a turn
inline constexpr double whole_turn = 360;          ///< degrees

enum class TurnProblem : std::uint8_t {
  no_motion,
  no_circle,       ///< the positions at constant speed are not on a circle
  less_than_turn,  ///< `degrees` are the most at constant speed, after settling
  few_points,      ///< `points`
};

struct BadTurn {
  TurnProblem problem = TurnProblem::no_motion;
  double degrees = 0;
  std::size_t points = 0;
};

/// One or two turns, in the order of time. Cost: some passes over the samples.
[[nodiscard]] std::variant<std::vector<Turn>, BadTurn> recorded_turns(RecordedPath const& path);

}  // namespace axisc::circle
