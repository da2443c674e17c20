#include "analysis/motion/tolerance.hpp"

#include "analysis/motion/limited_by.hpp"
#include "analysis/motion/searched_spans.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace axisc::motion {
namespace {

// Bounds on effort; what they end is settled by the proof or by the header's floor.

/// How often the path ahead is slowed down for a corner that the machine has passed: it cannot be slowed down
/// itself, so that half of the tries of others must do.
constexpr int most_tries_behind = most_tries / 2;
/// Plans, and two more for each corner, before all of the path is slowed down (see the header): a corner
/// ahead and one behind use up their tries one after the other.
constexpr int patient_rounds = most_tries + most_tries_behind;
/// Cells that one proof looks at: the first that fails ends it.
constexpr std::size_t proved_together = 16;
/// Below this share of a neighbour's error a corner waits for what slowing that one down does for it: so much
/// is only lacking where both are within reach of the same plateau.
constexpr double beside_worse = 0.9;
/// Cycles: rounding of the place of a time within its cycle.
constexpr double same_phase = 1e-7;

std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

std::uint64_t digest(TimedPiece const& piece) {
  std::uint64_t sum = 0;
  auto const add = [&](double x) { sum = mixed(sum ^ std::bit_cast<std::uint64_t>(x)); };
  for (double const x : piece.at(0)) add(x);
  add(piece.length);
  add(piece.duration);
  add(piece.phase.velocity_at(0));
  add(piece.phase.velocity_at(piece.duration / 2));
  add(piece.phase.velocity_at(piece.duration));
  return sum;
}

double phase_of(double time) {
  return time - std::floor(time);
}

bool is_same_phase(double a, double b) {
  double const apart = std::abs(a - b);
  return std::min(apart, 1 - apart) < same_phase;
}

/// √(Σ C²), cycles: see the header.
double farthest_per_velocity(std::span<ChainAnswer const> answers) {
  double earliest = unlimited;
  double latest = 0;
  for (auto const& answer : answers) {
    earliest = std::min(earliest, answer.delay);
    latest = std::max(latest, answer.delay);
  }
  double const delay = (earliest + latest) / 2;
  double squares = 0;
  for (auto const& answer : answers) {
    double sum = 0;
    for (std::size_t k = 0; k < answer.tap_count(); ++k) {
      sum += std::abs(answer.tap(k)) * (std::abs(static_cast<double>(k) - delay) + 1);
    }
    squares += sum * sum;
  }
  return std::sqrt(squares);
}

}  // namespace

ToleranceMonitor::ToleranceMonitor(GroupRuntime& probe, std::vector<ChainAnswer> const& answers,
                                   double tolerance, std::function<void()> working)
    : tolerance_(tolerance) {
  bool const delayed_alike = std::all_of(answers.begin(), answers.end(), [&](ChainAnswer const& answer) {
    return answer.only_delays() && answer.delay == answers.front().delay;
  });
  if (!(tolerance > 0) || delayed_alike) return;
  trial_ = std::make_unique<PathTrial>(probe, answers, std::move(working));
  circles_ = std::make_unique<CircleVelocities>(answers);
  plateau_ = trial_->reach();
  floor_ = largest_found * tolerance_ / farthest_per_velocity(answers);
}

double ToleranceMonitor::velocity_on(double radius) {
  // Quarters of a turn per cycle are not a circle any more.
  double const highest = circles_->highest(radius, largest_found * tolerance_).value_or(radius);
  return std::clamp(highest, floor_, std::max(floor_, radius));
}

/// The surroundings of each cell as a number, which changes when the path is passed differently.
void ToleranceMonitor::sign(TriedPath const& path, std::span<Corner const> corners) {
  auto const pieces = path.pieces;
  sums_.assign(1, 0);
  for (auto const& piece : pieces) sums_.push_back(sums_.back() + digest(piece));
  signatures_.clear();
  double const before = trial_->reach() + cycles_before();
  double const after = trial_->reach() + cycles_after();
  std::size_t begin = 0;
  std::size_t end = 0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    double from = corners[cells_[i]].time;
    double to = from;
    if (corners[cells_[i]].is_whole()) {
      from = i > 0 ? corners[cells_[i - 1]].time : path.valid_from;
      to = i + 1 < cells_.size() ? corners[cells_[i + 1]].time : pieces.back().end();
    }
    while (begin < pieces.size() && pieces[begin].end() < from - before) ++begin;
    while (end < pieces.size() && pieces[end].start <= to + after) ++end;
    signatures_.push_back(mixed(sums_[end] - sums_[begin]) + (end - begin));
  }
}

/// Tries cells whose surroundings are new.
void ToleranceMonitor::measure(TriedPath const& path, std::span<Corner> corners, Trial trial) {
  tried_.clear();
  wanted_.assign(cells_.size(), 0);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    auto const& corner = corners[cells_[i]];
    tried_.push_back({.place = corner.place, .time = corner.time, .whole = corner.is_whole()});
    bool const is_proved = corner.proved && is_same_phase(corner.phase, phase_of(corner.time));
    wanted_[i] = corner.tried_path != signatures_[i] || (trial == Trial::proof && !is_proved) ? 1 : 0;
  }
  double const end = path.pieces.back().end();
  auto const from = [&](std::size_t i) {
    double const near = tried_[i].time - trial_->reach();
    if (!tried_[i].whole) return std::max(near, path.valid_from);
    return i == 0 ? path.valid_from : std::max(path.valid_from, std::min(near, tried_[i - 1].time));
  };
  auto const to = [&](std::size_t i) {
    double const near = tried_[i].time + trial_->reach();
    if (!tried_[i].whole) return near;
    return i + 1 == cells_.size() ? end : std::max(near, tried_[i + 1].time);
  };
  for (std::size_t i = 0; i < cells_.size();) {
    if (wanted_[i] == 0) {
      ++i;
      continue;
    }
    double const first = from(i);
    double last = to(i);
    if (last < first) {
      wanted_[i++] = 0;
      continue;
    }
    // Cells whose surroundings meet are tried together.
    std::size_t const most = trial == Trial::proof ? i + proved_together : cells_.size();
    std::size_t next = i + 1;
    for (; next < std::min(most, cells_.size()) && wanted_[next] != 0 && from(next) <= last + cycles_before();
         ++next) {
      last = std::max(last, to(next));
    }
    // A corner bends most where it lies on a cycle: found so, its velocity holds for any time.
    bool const is_slowed = corners[cells_[i]].at.limits();
    bool const aligns = trial == Trial::search && is_slowed;
    TrialSpan const span{.from = first,
                         .to = last,
                         .phase = aligns ? phase_of(tried_[i].time) : 0,
                         .proves = trial == Trial::proof ? std::optional(tolerance_) : std::nullopt};
    if (trial == Trial::proof) {
      trial_->run(path.pieces, tried_, span);
    } else {
      for (auto const& part : searched_spans(path.pieces, span, cycles_before(), cycles_after())) {
        trial_->run(path.pieces, tried_, part);
      }
    }
    bool const exceeds =
        std::any_of(tried_.begin() + static_cast<std::ptrdiff_t>(i),
                    tried_.begin() + static_cast<std::ptrdiff_t>(next), [&](TriedCorner const& cell) {
                      return std::max(cell.error, cell.far_error) > largest_share * tolerance_;
                    });
    i = next;
    if (trial != Trial::proof || !exceeds) continue;
    // Slowed down, these corners shift the time at which the path passes all later ones.
    std::fill(wanted_.begin() + static_cast<std::ptrdiff_t>(i), wanted_.end(), char{0});
    unproved_ = true;
  }
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    auto& corner = corners[cells_[i]];
    if (wanted_[i] != 0) {
      corner.at.take(tried_[i].error, tried_[i].fastest);
      corner.around.take(tried_[i].far_error, tried_[i].far_fastest);
      corner.tried_path = signatures_[i];
      corner.proved = trial == Trial::proof;
      corner.phase = phase_of(corner.time);
    } else {
      corner.at.error = std::max(corner.at.error, tried_[i].error);
      corner.around.error = std::max(corner.around.error, tried_[i].far_error);
    }
  }
}

/// Only where a search limits the velocity does the error need a margin.
bool ToleranceMonitor::exceeds(VelocitySearch const& search, double limit) const {
  return search.error > (search.limits() ? limit : largest_share) * tolerance_;
}

bool ToleranceMonitor::lower(Corner& corner, double limit) const {
  // On an arc the error grows with the square of the velocity, on a line that axes leave with the velocity
  // itself.
  double const power = trial_->alike() ? 2 : 1;
  bool changes = false;
  bool is_far = exceeds(corner.around, limit);
  if (exceeds(corner.at, limit)) {
    bool const is_elsewhere = corner.is_whole() && corner.at.is_vain();
    if (!is_elsewhere) changes = corner.at.lower(tolerance_, floor_, 1);
    if (!changes && corner.is_whole()) {
      corner.at.velocity_before = 0;
      corner.around.error = std::max(corner.around.error, corner.at.error);
      is_far = true;
    }
  }
  if (is_far) changes = corner.around.lower(tolerance_, floor_, power) || changes;
  return changes;
}

bool ToleranceMonitor::slow_down(std::span<Corner> corners) const {
  double fastest = 0;
  for (auto const& corner : corners) {
    bool const is_covered = corner.covers_before && corner.covers_after;
    fastest =
        std::max(fastest, std::min(corner.around.fastest, is_covered ? corner.around.velocity : unlimited));
  }
  bool changes = false;
  for (auto& corner : corners) {
    corner.covers_before = corner.covers_after = true;
    for (auto* const search : {&corner.at, &corner.around}) {
      double const slower = std::min(search->velocity, std::max(floor_, fastest / 2));
      changes = changes || slower < search->velocity;
      search->velocity = slower;
    }
  }
  return changes;
}

double ToleranceMonitor::largest_around(std::span<Corner const> corners, std::size_t cell) const {
  auto const& corner = corners[cells_[cell]];
  double const aside = std::min(corner.at.velocity, corner.at.fastest) * plateau_;
  double found = 0;
  for (std::size_t i = cell; i-- > 0 && corner.place - corners[cells_[i]].place < aside;) {
    found = std::max(found, corners[cells_[i]].at.error);
  }
  for (std::size_t i = cell + 1; i < cells_.size() && corners[cells_[i]].place - corner.place < aside; ++i) {
    found = std::max(found, corners[cells_[i]].at.error);
  }
  return found;
}

ToleranceMonitor::Change ToleranceMonitor::adjust(std::span<Corner> corners, double limit,
                                                  bool raises) const {
  std::vector<std::size_t> exceeding;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    auto const& corner = corners[cells_[i]];
    if (exceeds(corner.at, limit) || exceeds(corner.around, limit)) exceeding.push_back(i);
  }
  // Next to a worse corner, that corner's plateau may suffice.
  auto const others = std::stable_partition(exceeding.begin(), exceeding.end(), [&](std::size_t i) {
    auto const& corner = corners[cells_[i]];
    return exceeds(corner.around, limit) || corner.at.error >= beside_worse * largest_around(corners, i);
  });
  bool changes = false;
  auto const lower_cell = [&](std::size_t i) { changes = lower(corners[cells_[i]], limit) || changes; };
  std::for_each(exceeding.begin(), others, lower_cell);
  if (!changes) std::for_each(others, exceeding.end(), lower_cell);
  if (!exceeding.empty() && !changes) return Change::stuck;
  for (std::size_t i = 0; raises && i < cells_.size(); ++i) {
    auto& corner = corners[cells_[i]];
    if (corner.passed) continue;
    bool const is_slow = corner.at.limits() && corner.at.error < smallest_found * tolerance_;
    // A neighbour that is at the tolerance needs this plateau, too.
    bool const is_free = is_slow && largest_around(corners, i) <= smallest_found * tolerance_;
    if (is_free && corner.at.raise(tolerance_)) changes = true;
    if (corner.around.raise(tolerance_)) changes = true;
  }
  return changes ? Change::some : Change::none;
}

ToleranceMonitor::Verdict ToleranceMonitor::judge(TriedPath const& path, std::span<Corner> corners,
                                                  int round) {
  cells_.clear();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i].turns) cells_.push_back(i);
  }
  if (path.pieces.empty() || cells_.empty()) return Verdict::keeps;
  if (round == 0) proving_ = false;
  sign(path, corners);
  // First only the cells that are passed differently; if they hold, everything as the machine will pass it.
  measure(path, corners, Trial::search);
  bool const refines = round <= refining_rounds && !proving_;
  auto change = adjust(corners, proving_ ? largest_share : largest_found, refines);
  if (change == Change::none) {
    proving_ = true;
    unproved_ = false;
    measure(path, corners, Trial::proof);
    change = adjust(corners, largest_share, false);
    if (change == Change::none) return unproved_ ? Verdict::changed : Verdict::keeps;
  }
  if (change == Change::stuck || round > patient_rounds + 2 * static_cast<int>(corners.size())) {
    if (corners.front().passed) return Verdict::fails;
    return slow_down(corners) ? Verdict::changed : Verdict::exceeds;
  }
  bool const is_lost = std::any_of(corners.begin(), corners.end(), [](Corner const& corner) {
    int const most = corner.passed ? most_tries_behind : most_tries;
    return corner.at.lowered > most || corner.around.lowered > most;
  });
  return is_lost ? Verdict::fails : Verdict::changed;
}

}  // namespace axisc::motion
