#include "analysis/circle/external_turns.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace axisc::circle {

namespace {

/// Of a point: a turn of 0° to 359.5° every 0.5° is a whole one.
constexpr double missing = 1.5;

}  // namespace

std::variant<std::vector<Turn>, BadTurn> external_turns(std::vector<double> const& angles_deg,
                                                        std::vector<double> const& deviations,
                                                        double radius) {
  std::vector<Turn> turns;
  BadTurn bad{.problem = TurnProblem::less_than_turn};
  auto const step = [&](std::size_t i) {
    return std::remainder(angles_deg[i] - angles_deg[i - 1], whole_turn);
  };
  for (std::size_t end = angles_deg.size(); end > 1;) {
    // Back from the last point, as long as the angle changes in one direction, at most once around.
    std::size_t begin = end - 1;
    double covered = 0;
    while (begin > 0 && step(begin) * covered >= 0 && std::abs(covered) < whole_turn) {
      covered += step(begin--);
    }
    std::size_t const points = end - begin;
    auto const sense = covered < 0 ? Sense::clockwise : Sense::counterclockwise;
    bool const is_whole =
        points > 1 && std::abs(covered) * (1 + missing / static_cast<double>(points - 1)) >= whole_turn;
    bool const is_known =
        std::any_of(turns.begin(), turns.end(), [&](Turn const& turn) { return turn.sense == sense; });
    if (!is_whole && std::abs(covered) > bad.degrees) bad.degrees = std::abs(covered);
    if (is_whole && points < fewest_points) return BadTurn{TurnProblem::few_points, whole_turn, points};
    if (is_whole && !is_known) {
      Turn turn{.sense = sense, .samples = {}, .radius = radius};
      std::vector<double> angles;
      double angle = angles_deg[begin];
      for (std::size_t i = begin; i < end; ++i) {
        if (i > begin) angle += step(i);
        angles.push_back(angle * degree);
        double const distance = radius + deviations[i];
        turn.samples.push_back(
            {.u = distance * std::cos(angle * degree), .v = distance * std::sin(angle * degree)});
      }
      weigh(turn.samples, angles);
      turns.push_back(std::move(turn));
    }
    // The point where the direction changes belongs to both.
    end = begin == 0 ? 0 : std::min(begin + 1, end - 1);
  }
  if (turns.empty()) return bad;
  std::reverse(turns.begin(), turns.end());
  return turns;
}

}  // namespace axisc::circle
