#include "analysis/comparison/motion/motion_comparison.hpp"

#include "analysis/comparison/motion/planned_move.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace axisc::comparison {

namespace {

/// Deviation of a reading for which no move is planned.
constexpr double without_plan = std::numeric_limits<double>::infinity();

/// Of a move, by the readings of the keys that act in it.
struct ComparedMove {
  MotionKeys keys;
  std::map<Combination, Deviation> deviations;

  [[nodiscard]] Deviation const& least() const {
    auto const by_excess = [](auto const& a, auto const& b) { return a.second.excess < b.second.excess; };
    return std::min_element(deviations.begin(), deviations.end(), by_excess)->second;
  }
};

ComparedMove compared(Move const& move, motion::PathDynamics const& dynamics, RecordedPath const& path,
                      Stretch const& moving, Stretch const& free) {
  ComparedMove found{.keys = acting_keys(move, dynamics), .deviations = {}};
  std::map<std::vector<motion::Point>, Deviation> known;  // many readings plan alike
  for (auto const& combination : all_combinations()) {
    auto const readings = only(combination, found.keys);
    if (found.deviations.contains(readings)) continue;
    auto const plan = planned_setpoints(move, dynamics, readings, path.size() + 1);
    if (!plan) {
      found.deviations[readings] = {.largest = without_plan, .excess = without_plan};
      continue;
    }
    auto const [place, is_new] = known.try_emplace(*plan);
    if (is_new) place->second = deviation_of(*plan, path, moving, free);
    found.deviations[readings] = place->second;
  }
  return found;
}

/// Both ends are rounded.
bool same_way(Move const& move, RecordedPath const& path, Stretch const& stretch) {
  return std::all_of(path.positions.begin(), path.positions.end(), [&](RecordedPosition const& position) {
    double const recorded = position.values[stretch.end] - position.values[stretch.begin];
    double const planned = move.end()[position.axis] - move.begin[position.axis];
    return std::abs(recorded - planned) <= 2 * position.allowed;
  });
}

bool same_ways(std::vector<Move> const& moves, RecordedPath const& path, std::vector<Stretch> const& found,
               std::size_t first) {
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (!same_way(moves[i], path, found[first + i])) return false;
  }
  return true;
}

bool shows(Move const& move, RecordedPath const& path) {
  auto from = move.begin;
  for (auto const& block : move.blocks) {
    for (auto const& position : path.positions) {
      bool const is_in_plane =
          block.arc && (block.arc->first == position.axis || block.arc->second == position.axis);
      if (is_in_plane || block.end[position.axis] != from[position.axis]) return true;
    }
    from = block.end;
  }
  return false;
}

ExplainedMotion explained(Combination const& combination, std::vector<ComparedMove> const& moves) {
  ExplainedMotion whole{.readings = combination, .deviation = {}};
  for (auto const& move : moves) {
    whole.deviation.add(move.deviations.at(only(combination, move.keys)));
  }
  return whole;
}

MotionComparison judged(std::vector<ComparedMove> const& all_moves, machine::MotionReadings const& current) {
  MotionComparison result{.moves = all_moves.size(),
                          .cycles = 0,
                          .current = explained(combination_of(current), all_moves),
                          .best = {},
                          .unexplained = {},
                          .keys = {}};
  std::vector<ComparedMove> moves;
  std::copy_if(all_moves.begin(), all_moves.end(), std::back_inserter(moves),
               [](ComparedMove const& move) { return move.least().fits(); });
  if (moves.empty()) moves = all_moves;
  result.best = explained(combination_of(current), moves);
  std::vector<ExplainedMotion> all;
  for (auto const& combination : all_combinations()) {
    auto const& one = all.emplace_back(explained(combination, moves));
    bool const is_better = one.deviation.excess < result.best.deviation.excess;
    if (!result.best.deviation.fits() && is_better) result.best = one;
  }
  for (std::size_t key = 0; key < motion_key_count; ++key) {
    auto& verdict = result.keys.at(key);
    verdict.acts = std::any_of(moves.begin(), moves.end(),
                               [key](ComparedMove const& move) { return move.keys.test(key); });
    for (auto const& one : all) {
      auto const word = one.readings.at(key);
      bool const is_known = std::count(verdict.possible.begin(), verdict.possible.end(), word) > 0;
      if (one.deviation.fits() && !is_known) verdict.possible.push_back(word);
    }
    std::sort(verdict.possible.begin(), verdict.possible.end());
    if (!verdict.is_told()) continue;
    for (auto const& one : all) {
      if (one.readings.at(key) == verdict.possible.front()) continue;
      if (!verdict.next || one.deviation.excess < verdict.next->deviation.excess) verdict.next = one;
    }
  }
  return result;
}

}  // namespace

std::variant<MotionComparison, NoSuchMoves> compare_motion(std::vector<Move> const& moves,
                                                           motion::PathDynamics const& dynamics,
                                                           RecordedPath const& path) {
  // Moves of axes without a column leave no trace.
  std::vector<Move> seen;
  std::copy_if(moves.begin(), moves.end(), std::back_inserter(seen),
               [&path](Move const& move) { return shows(move, path); });
  auto const rest = static_cast<std::size_t>(shortest_pause_s / 2 / dynamics.cycle_time.seconds());
  auto const found = moving_stretches(path, rest);
  std::optional<MotionComparison> best;
  for (std::size_t first = 0; !seen.empty() && first + seen.size() <= found.size(); ++first) {
    if (!same_ways(seen, path, found, first)) continue;
    std::vector<ComparedMove> compared_moves;
    std::size_t cycles = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      auto const at = first + i;
      Stretch const free{.begin = at > 0 ? found[at - 1].end : 0,
                         .end = at + 1 < found.size() ? found[at + 1].begin : path.size() - 1};
      compared_moves.push_back(compared(seen[i], dynamics, path, found[at], free));
      cycles += found[at].end - found[at].begin;
    }
    auto result = judged(compared_moves, dynamics.readings);
    result.cycles = cycles;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      auto const& least = compared_moves[i].least();
      if (least.fits()) continue;
      auto const& block = seen[i].blocks.front();
      result.unexplained.push_back({.line = block.line, .block = block.label, .largest = least.largest});
    }
    bool const is_better = best && (result.unexplained.size() < best->unexplained.size() ||
                                    (result.unexplained.size() == best->unexplained.size() &&
                                     result.best.deviation.excess < best->best.deviation.excess));
    if (!best || is_better) best = std::move(result);
  }
  if (!best) return NoSuchMoves{.programmed = seen.size(), .recorded = found.size()};
  return *std::move(best);
}

}  // namespace axisc::comparison
