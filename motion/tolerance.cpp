#include "motion/tolerance.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace axisc::motion {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
/// Shares of the tolerance. Errors above the first are too large; between the points that are looked at they may still be a
/// little larger. A velocity is found where it leaves errors between the next two, so that a few more or less do no harm
/// when the path passes a corner at another time in its cycle. The last one is aimed at.
constexpr double largest = 0.997;
constexpr double largest_found = 0.989;
constexpr double smallest_found = 0.975;
constexpr double aimed_at = 0.982;
/// Corners are raised in the first plans only; then they are lowered until every one holds.
constexpr int refining_rounds = 12;
constexpr int most_raises = 6;
/// So often the path ahead is slowed down for a corner behind the machine.
constexpr int most_tries_behind = 20;
/// And so often for any.
constexpr int most_tries = 40;
constexpr int patient_rounds = 60;
constexpr std::size_t proved_together = 16;
constexpr double beside_worse = 0.9;
constexpr double same_phase = 1e-7;
/// A smaller power of the velocity says that something else than this corner's velocity makes the error.
constexpr double least_growth = 0.3;

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
  add(piece.profile.velocity_at(0));
  add(piece.profile.velocity_at(piece.duration / 2));
  add(piece.profile.velocity_at(piece.duration));
  return sum;
}

double phase_of(double time) {
  return time - std::floor(time);
}

bool is_same_phase(double a, double b) {
  double const apart = std::abs(a - b);
  return std::min(apart, 1 - apart) < same_phase;
}

/// Power of the velocity with which the error grows, from the last two trials; 1 where they do not tell.
double growth(Corner const& corner, double velocity) {
  if (!(corner.velocity_before > 0) || !(corner.error_before > 0) || !(corner.error > 0)) return 1;
  double const apart = std::log(velocity / corner.velocity_before);
  if (std::abs(apart) < 1e-4) return 1;
  double const power = std::log(corner.error / corner.error_before) / apart;
  return power > least_growth ? std::min(power, 3.0) : 1;
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
    auto const& r = answer.ramp;
    double sum = 0;
    for (std::size_t k = 0; k + 1 < r.size(); ++k) {
      // The impulse response is the second difference of the ramp's.
      double const b = r[k + 1] - 2 * r[k] + (k > 0 ? r[k - 1] : 0.0);
      sum += std::abs(b) * (std::abs(static_cast<double>(k) - delay) + 1);
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
  // Quarters of a turn per cycle are no circle any more.
  double const highest = circles_->highest(radius, largest_found * tolerance_).value_or(radius);
  return std::clamp(highest, floor_, std::max(floor_, radius));
}

/// The surroundings of each cell as a number: another one where the path is passed otherwise.
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
    if (is_whole(corners[cells_[i]])) {
      from = i > 0 ? corners[cells_[i - 1]].time : path.valid_from;
      to = i + 1 < cells_.size() ? corners[cells_[i + 1]].time : pieces.back().end();
    }
    while (begin < pieces.size() && pieces[begin].end() < from - before) ++begin;
    while (end < pieces.size() && pieces[end].start <= to + after) ++end;
    signatures_.push_back(mixed(sums_[end] - sums_[begin]) + (end - begin));
  }
}

/// Tries what is new.
void ToleranceMonitor::measure(TriedPath const& path, std::span<Corner> corners, Trial trial) {
  tried_.clear();
  wanted_.assign(cells_.size(), 0);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    auto const& corner = corners[cells_[i]];
    tried_.push_back({.place = corner.place, .time = corner.time, .whole = is_whole(corner)});
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
    bool const is_slowed = corners[cells_[i]].velocity != unlimited;
    bool const aligns = trial == Trial::search && is_slowed;
    trial_->run(path.pieces, tried_,
                {.from = first,
                 .to = last,
                 .phase = aligns ? phase_of(tried_[i].time) : 0,
                 .looks_between = trial == Trial::proof});
    bool const exceeds = std::any_of(
        tried_.begin() + static_cast<std::ptrdiff_t>(i), tried_.begin() + static_cast<std::ptrdiff_t>(next),
        [&](TriedCorner const& cell) { return cell.error > largest * tolerance_; });
    i = next;
    if (trial != Trial::proof || !exceeds) continue;
    // Slowed down, these corners shift the time at which the path passes all later ones.
    std::fill(wanted_.begin() + static_cast<std::ptrdiff_t>(i), wanted_.end(), char{0});
    unproved_ = true;
  }
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    auto& corner = corners[cells_[i]];
    if (wanted_[i] != 0) {
      corner.error = tried_[i].error;
      corner.far_error = tried_[i].far_error;
      corner.tried_fastest = tried_[i].fastest;
      corner.tried_velocity = std::min(corner.velocity, tried_[i].fastest);
      corner.tried_path = signatures_[i];
      corner.proved = trial == Trial::proof;
      corner.phase = phase_of(corner.time);
    } else {
      corner.error = std::max(corner.error, tried_[i].error);
    }
  }
}

/// A plateau within the kernels' reach does not mend it.
bool ToleranceMonitor::needs_more(Corner const& corner) const {
  if (!trial_->alike()) return corner.lowered > 0 && corner.error > 0.9 * corner.error_before;
  if (corner.far_error > largest_found * tolerance_) return true;
  double const slower = corner.velocity_before > 0 ? corner.tried_velocity / corner.velocity_before : 1;
  return slower < 0.95 && corner.error > std::pow(slower, least_growth) * corner.error_before;
}

bool ToleranceMonitor::lower(Corner& corner) const {
  // What a slower corner does not mend, a slower path around it does.
  if (is_whole(corner) && !corner.wide && needs_more(corner)) {
    corner.wide = true;
    corner.velocity = unlimited;
    corner.tried_velocity = corner.tried_fastest;
    corner.kept = corner.velocity_before = 0;
    corner.exceeded = unlimited;
  }
  if (corner.velocity <= floor_) {
    if (corner.wide) return false;
    corner.wide = true;
    return true;
  }
  ++corner.lowered;
  double const from = corner.tried_velocity > 0 ? std::min(corner.tried_velocity, corner.velocity)
                                                : std::min(corner.fastest, corner.velocity);
  double next = from * std::pow(aimed_at * tolerance_ / corner.error, 1 / growth(corner, from));
  corner.exceeded = std::min(corner.exceeded, from);
  if (corner.kept >= from) corner.kept = 0;
  if (corner.lowered <= refining_rounds) {
    if (next <= corner.kept) next = (corner.kept + from) / 2;
  } else {
    // Each time a little harder, so that this comes to its end.
    next *= std::max(0.5, 1 - 0.02 * (corner.lowered - refining_rounds));
  }
  corner.velocity_before = from;
  corner.error_before = corner.error;
  corner.velocity = std::max(floor_, std::min(next, 0.998 * from));
  return true;
}

/// Half the velocity everywhere. False where the floor has been reached.
bool ToleranceMonitor::slow_down(std::span<Corner> corners) const {
  double fastest = 0;
  for (auto const& corner : corners) {
    if (!corner.passed) fastest = std::max(fastest, std::min(corner.velocity, corner.fastest));
  }
  bool changes = false;
  for (auto& corner : corners) {
    if (corner.passed) continue;
    changes = changes || !corner.wide || corner.velocity > floor_;
    corner.wide = true;
    corner.velocity = std::min(corner.velocity, std::max(floor_, fastest / 2));
  }
  return changes;
}

double ToleranceMonitor::largest_around(std::span<Corner const> corners, std::size_t cell) const {
  auto const& corner = corners[cells_[cell]];
  double const aside = std::min(corner.velocity, corner.fastest) * plateau_;
  double found = 0;
  for (std::size_t i = cell; i-- > 0 && corner.place - corners[cells_[i]].place < aside;) {
    found = std::max(found, corners[cells_[i]].error);
  }
  for (std::size_t i = cell + 1; i < cells_.size() && corners[cells_[i]].place - corner.place < aside; ++i) {
    found = std::max(found, corners[cells_[i]].error);
  }
  return found;
}

bool ToleranceMonitor::raise(std::span<Corner> corners, std::size_t cell) const {
  auto& corner = corners[cells_[cell]];
  bool const slows_the_path = corner.tried_velocity >= 0.999 * corner.velocity;
  if (corner.passed || corner.raised >= most_raises || !slows_the_path) return false;
  corner.kept = std::max(corner.kept, corner.velocity);
  if (corner.exceeded <= corner.kept) corner.exceeded = unlimited;
  if (corner.exceeded < corner.kept * 1.004) return false;
  // A neighbour that is at the tolerance needs this plateau, too.
  if (largest_around(corners, cell) > smallest_found * tolerance_) return false;
  ++corner.raised;
  double const share = std::clamp(aimed_at * tolerance_ / std::max(corner.error, 1e-9), 1.0, 4.0);
  double next = corner.velocity * std::pow(share, 1.0 / growth(corner, corner.velocity));
  if (next >= corner.exceeded) next = (corner.kept + corner.exceeded) / 2;
  corner.velocity_before = corner.velocity;
  corner.error_before = corner.error;
  if (next >= corner.fastest) next = unlimited;
  corner.velocity = next;
  return true;
}

ToleranceMonitor::Change ToleranceMonitor::adjust(std::span<Corner> corners, double limit,
                                                  bool raises) const {
  bool exceeded = false;
  bool lowers = false;
  std::vector<std::size_t> lowered;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    auto const& corner = corners[cells_[i]];
    // What nothing slows down need not leave room.
    double const allowed = corner.velocity == unlimited ? largest : limit;
    if (!(corner.error > allowed * tolerance_)) continue;
    exceeded = true;
    // Beside a corner that is worse, its plateau may do.
    if (corner.error >= beside_worse * largest_around(corners, i)) lowered.push_back(cells_[i]);
  }
  for (auto const i : lowered) lowers = lower(corners[i]) || lowers;
  if (exceeded && !lowers) return Change::stuck;
  bool raised = false;
  for (std::size_t i = 0; raises && i < cells_.size(); ++i) {
    auto const& corner = corners[cells_[i]];
    bool const is_slow = corner.velocity != unlimited && corner.error < smallest_found * tolerance_;
    if (is_slow && raise(corners, i)) raised = true;
  }
  return exceeded || raised ? Change::some : Change::none;
}

ToleranceMonitor::Verdict ToleranceMonitor::judge(TriedPath const& path, std::span<Corner> corners,
                                                  int round) {
  cells_.clear();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i].turns || !trial_->alike()) cells_.push_back(i);
  }
  if (path.pieces.empty() || cells_.empty()) return Verdict::keeps;
  if (round == 0) proving_ = false;
  sign(path, corners);
  // First what is passed otherwise; where that holds, everything as the machine will pass it.
  measure(path, corners, Trial::search);
  bool const refines = round <= refining_rounds && !proving_;
  auto change = adjust(corners, proving_ ? largest : largest_found, refines);
  if (change == Change::none) {
    proving_ = true;
    unproved_ = false;
    measure(path, corners, Trial::proof);
    change = adjust(corners, largest, false);
    if (change == Change::none) return unproved_ ? Verdict::changed : Verdict::keeps;
  }
  if (change == Change::stuck || round > patient_rounds + 2 * static_cast<int>(corners.size())) {
    if (corners.front().passed) return Verdict::fails;
    return slow_down(corners) ? Verdict::changed : Verdict::exceeds;
  }
  bool const is_lost = std::any_of(corners.begin(), corners.end(), [](Corner const& corner) {
    return corner.lowered > (corner.passed ? most_tries_behind : most_tries);
  });
  return is_lost ? Verdict::fails : Verdict::changed;
}

}  // namespace axisc::motion
