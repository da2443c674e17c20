#include "analysis/motion/look_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axisc::motion {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
/// Position units: shorter stretches are nothing but rounding.
constexpr double no_length = 1e-9;
/// Acceleration that reaches any velocity at once.
constexpr double at_once = 1e200;
/// A smaller change of direction comes from rounded end points.
constexpr double no_turn = 1e-12;

}  // namespace

void LookAhead::begin(Point const& position, ToleranceMonitor monitor, double acceleration_factor) {
  position_ = position;
  monitor_ = constant_velocity_ ? ToleranceMonitor() : std::move(monitor);
  acceleration_factor_ = acceleration_factor;
  full_ = window_;
}

void LookAhead::add(ProgrammedBlock const& block) {
  Point way = minus(block.end, position_);
  double const distance = block.arc ? block.arc->length : motion::length(way);
  if (!(distance > 0)) return;
  PathBlock added;
  added.end = block.end;
  added.length = distance;
  if (block.arc) {
    way[block.arc->first] = way[block.arc->second] = 0;
    added.path = Segment(position_, plus({}, 1 / distance, way), block.arc);
    added.velocity = block.feed;
    if (!constant_velocity_) {
      added.velocity = std::min({block.feed, limits_.velocity(added.path), tolerated(*block.arc)});
    }
    added.acceleration = limits_.acceleration(added.path, added.velocity);
  } else {
    auto const direction = plus({}, 1 / distance, way);
    added.path = Segment(position_, direction);
    added.velocity = std::min(block.feed, limits_.velocity(direction));
    added.acceleration = limits_.acceleration(direction);
  }
  added.smooth = block.dynamics && block.dynamics->slope == machine::Slope::sin2;
  if (added.smooth) added.acceleration /= 2;
  if (constant_velocity_) added.acceleration = at_once;
  added.index = next_index_++;
  added.line = block.line;
  added.label = block.label;
  position_ = block.end;
  blocks_.push_back(std::move(added));
  if (blocks_.size() >= full_) plan(false);
}

/// The velocity at which a circle keeps the tolerance long after its beginning; its beginning and end are
/// tried.
double LookAhead::tolerated(Arc const& arc) {
  return monitor_.active() ? monitor_.velocity_on(arc.curvature_radius()) : unlimited;
}

void LookAhead::stop() {
  if (!blocks_.empty()) plan(true);
  last_block_ = {};
  forget();
}

/// The path rests, and nothing before it counts any more.
void LookAhead::forget() {
  velocity_ = 0;
  corners_.clear();
  has_end_corner_ = false;
  passed_corners_ = 0;
  path_.clear();
  passed_pieces_ = 0;
  time_ = valid_from_ = 0;
  kept_.clear();
  kept_blocks_ = 0;
}

/// At rest there is no block on one side.
Corner LookAhead::corner_between(PathBlock const* before, PathBlock const* after, bool is_sharp) const {
  auto const covers = [&](PathBlock const* block) {
    return block != nullptr && (block->path.arc() != nullptr || !monitor_.alike());
  };
  Corner corner;
  corner.covers_before = covers(before);
  corner.covers_after = covers(after);
  corner.turns = is_sharp || corner.is_whole();
  for (auto const* const block : {before, after}) {
    if (block != nullptr) corner.at.fastest = std::max(corner.at.fastest, block->velocity);
  }
  corner.around.fastest = corner.at.fastest;
  return corner;
}

/// Corners of blocks that were in the window already keep what is known about them.
void LookAhead::collect_corners() {
  if (has_end_corner_) corners_.pop_back();
  has_end_corner_ = false;
  places_.assign(1, 0);
  for (auto const& block : blocks_) places_.push_back(places_.back() + block.length);
  if (!monitor_.active()) return;
  std::size_t const known = corners_.size() - passed_corners_;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (i < known) {
      corners_[passed_corners_ + i].place = places_[i];
      continue;
    }
    auto const& block = blocks_[i];
    auto const& before = i > 0 ? blocks_[i - 1] : last_block_;
    bool const moves = i > 0 || velocity_ > 0;
    Point const turn = minus(block.direction_in(), before.direction_out());
    bool const is_sharp =
        moves && std::any_of(turn.begin(), turn.end(), [](double u) { return std::abs(u) > no_turn; });
    corners_.push_back(corner_between(moves ? &before : nullptr, &block, is_sharp));
    corners_.back().place = places_[i];
  }
  corners_.push_back(corner_between(&blocks_.back(), nullptr, false));
  corners_.back().place = places_.back();
  has_end_corner_ = true;
}

/// Stretches of the path that are passed no faster than a velocity: from, to, velocity, index of the corner.
template <class Take>
void LookAhead::for_each_plateau(Take take) const {
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    auto const& corner = corners_[i];
    if (corner.at.limits()) {
      double const aside = corner.at.velocity * monitor_.plateau();
      take(corner.place - aside, corner.place + aside, corner.at.velocity, i);
    }
    if (!corner.around.limits()) continue;
    bool const before = corner.covers_before && i > 0;
    bool const after = corner.covers_after && i + 1 < corners_.size();
    take(before ? (corners_[i - 1].place + corner.place) / 2 : corner.place,
         after ? (corner.place + corners_[i + 1].place) / 2 : corner.place, corner.around.velocity, i);
  }
}

void LookAhead::cut_into_stretches() {
  cuts_ = places_;
  for_each_plateau([this](double from, double to, double /*velocity*/, std::size_t /*corner*/) {
    for (double const end : {from, to}) {
      if (end > 0 && end < places_.back()) cuts_.push_back(end);
    }
  });
  std::sort(cuts_.begin(), cuts_.end());
  stretches_.clear();
  std::size_t block = 0;
  double from = 0;
  for (double const cut : cuts_) {
    bool const ends_block = cut == places_[block + 1];
    if (cut - from > no_length || ends_block) {
      auto const& asked = blocks_[block];
      stretches_.push_back({.block = block,
                            .piece = {.length = std::max(0.0, cut - from),
                                      .velocity_limit = asked.velocity,
                                      .acceleration = asked.acceleration,
                                      .smooth = asked.smooth},
                            .ends_block = ends_block});
      from = cut;
    }
    if (ends_block && block + 1 < blocks_.size()) ++block;
  }
}

void LookAhead::limit_by_plateaus() {
  cuts_.clear();
  double place = 0;
  for (auto const& stretch : stretches_) cuts_.push_back(place += stretch.piece.length);
  for_each_plateau([this](double begin, double end, double velocity, std::size_t corner) {
    bool const is_for_stop = corner + 1 == corners_.size();
    auto at = static_cast<std::size_t>(std::upper_bound(cuts_.begin(), cuts_.end(), begin + no_length) -
                                       cuts_.begin());
    for (; at < stretches_.size() && cuts_[at] - stretches_[at].piece.length < end - no_length; ++at) {
      auto& piece = stretches_[at].piece;
      if (!(piece.velocity_limit > velocity)) continue;
      piece.velocity_limit = velocity;
      if (is_for_stop) touched_ = std::min(touched_, at);
    }
  });
}

/// False where the path would have to brake harder than it can.
bool LookAhead::choose_velocities() {
  std::size_t const count = stretches_.size();
  velocities_.assign(count + 1, unlimited);
  velocities_[count] = constant_velocity_ ? unlimited : 0;
  for (std::size_t i = 0; i < count; ++i) {
    double const limit = stretches_[i].piece.velocity_limit;
    velocities_[i] = std::min(velocities_[i], limit);
    velocities_[i + 1] = std::min(velocities_[i + 1], limit);
    if (!stretches_[i].ends_block || i + 1 == count || constant_velocity_) continue;
    auto const turn =
        minus(blocks_[stretches_[i + 1].block].direction_in(), blocks_[stretches_[i].block].direction_out());
    velocities_[i + 1] = std::min(velocities_[i + 1], limits_.corner(turn, acceleration_factor_));
  }
  auto const before = [&](std::size_t i) {
    auto const& piece = stretches_[i].piece;
    double const next = velocities_[i + 1];
    return std::sqrt(next * next + 2 * piece.acceleration * piece.length);
  };
  for (std::size_t i = count; i-- > 1;) {
    double const braking = before(i);
    if (touched_ == i + 1 && braking <= velocities_[i]) touched_ = i;
    velocities_[i] = std::min(velocities_[i], braking);
  }
  bool feasible = true;
  if (!constant_velocity_) {
    velocities_[0] = velocity_;
    feasible = velocity_ <= before(0) * (1 + 1e-9);
  }
  // The stretch before the first that brakes for the stop ends with another velocity without it.
  if (touched_ > 0) --touched_;
  for (std::size_t i = 0; i < count; ++i) {
    auto& piece = stretches_[i].piece;
    double const now = velocities_[i];
    velocities_[i + 1] =
        std::min(velocities_[i + 1], std::sqrt(now * now + 2 * piece.acceleration * piece.length));
    piece.velocity_in = now;
    piece.velocity_out = velocities_[i + 1];
  }
  return feasible;
}

void LookAhead::make_plan() {
  cut_into_stretches();
  touched_ = stretches_.size();
  if (monitor_.active()) limit_by_plateaus();
  feasible_ = choose_velocities();
}

/// When the plan passes its stretches and corners.
void LookAhead::time_plan() {
  path_.resize(passed_pieces_);
  double time = time_;
  double within = 0;  // the block
  for (auto const& stretch : stretches_) {
    auto const& block = blocks_[stretch.block];
    if (within == 0) corners_[passed_corners_ + stretch.block].time = time;
    TimedPiece piece;
    piece.path = block.path;
    piece.from = within;
    piece.length = stretch.piece.length;
    piece.profile = VelocityProfile(stretch.piece);
    piece.place = places_[stretch.block] + within;
    piece.start = time;
    piece.duration = piece.profile.duration();
    piece.ends_block = stretch.ends_block;
    time += piece.duration;
    within = stretch.ends_block ? 0 : within + stretch.piece.length;
    path_.push_back(piece);
  }
  corners_.back().time = time;
}

/// One cycle more for each end, which need not lie on one.
bool LookAhead::is_too_long() const {
  return !(path_.back().end() - time_ <= sink_.room() + 2);
}

/// Plans until the tolerance is kept. False where it cannot be.
bool LookAhead::keep_tolerance() {
  for (int round = 0; feasible_; ++round) {
    time_plan();
    if (is_too_long()) return true;
    auto const verdict = monitor_.judge({.pieces = path_, .valid_from = valid_from_}, corners_, round);
    if (verdict == ToleranceMonitor::Verdict::keeps) return true;
    bool const is_lost = verdict != ToleranceMonitor::Verdict::changed;
    if (is_lost && kept_blocks_ > 0) return false;
    // All of it is as slow as it may be; the simulation's measurement has the last word.
    if (verdict == ToleranceMonitor::Verdict::exceeds) return true;
    make_plan();
  }
  return false;
}

/// Blocks that end so early that no later plan changes what is measured on them.
std::size_t LookAhead::untouched_blocks() const {
  double const end = path_[passed_pieces_ + touched_].start - monitor_.cycles_after();
  std::size_t count = 0;
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    if (!stretches_[i].ends_block) continue;
    if (path_[passed_pieces_ + i].end() > end) break;
    count = stretches_[i].block + 1;
  }
  return std::min(count, blocks_.size() - 1);
}

void LookAhead::plan(bool stops) {
  while (!blocks_.empty()) {
    collect_corners();
    make_plan();
    if (!monitor_.active()) return hand_on(stops ? blocks_.size() : window_ / 2, stops);
    if (!keep_tolerance()) {
      drive_kept_plan();
      continue;
    }
    if (stops || is_too_long()) {
      hand_on(blocks_.size(), true);
      return forget();
    }
    auto const count = untouched_blocks();
    full_ = std::max(blocks_.size() - count + window_ / 2, window_);
    if (count > 0) hand_on(count, false);
    return;
  }
}

void LookAhead::hand_on(std::size_t count, bool stops) {
  std::size_t i = 0;
  for (; i < stretches_.size() && stretches_[i].block < count; ++i) {
    auto const& stretch = stretches_[i];
    auto const& block = blocks_[stretch.block];
    sink_.piece(block, stretch.piece);
    if (!stretch.ends_block) continue;
    bool const last = stops && stretch.block + 1 == blocks_.size();
    sink_.block_end(block, last ? nullptr : &blocks_[stretch.block + 1]);
    velocity_ = stretch.piece.velocity_out;
  }
  // Where the path stops, nothing is left to look back at.
  if (monitor_.active() && !stops) {
    kept_.assign(stretches_.begin() + static_cast<std::ptrdiff_t>(i), stretches_.end());
    for (auto& stretch : kept_) stretch.block -= count;
    kept_blocks_ = blocks_.size() - count;
    remember(count);
  }
  last_block_ = blocks_[count - 1];
  blocks_.erase(blocks_.begin(), blocks_.begin() + static_cast<std::ptrdiff_t>(count));
}

/// The rest of the last plan that kept the tolerance, until the filters have settled where it stops.
void LookAhead::drive_kept_plan() {
  for (auto const& stretch : kept_) {
    auto const& block = blocks_[stretch.block];
    sink_.piece(block, stretch.piece);
    if (!stretch.ends_block) continue;
    bool const last = stretch.block + 1 == kept_blocks_;
    sink_.block_end(block, last ? nullptr : &blocks_[stretch.block + 1]);
  }
  last_block_ = blocks_[kept_blocks_ - 1];
  sink_.rest(last_block_, static_cast<std::uint64_t>(monitor_.cycles_before() + monitor_.cycles_after()));
  blocks_.erase(blocks_.begin(), blocks_.begin() + static_cast<std::ptrdiff_t>(kept_blocks_));
  forget();
}

/// Keeps the part of the path that the next plan looks back at: times count from the last whole cycle, places
/// from the window.
void LookAhead::remember(std::size_t count) {
  std::size_t pieces = passed_pieces_;
  for (auto const& stretch : stretches_) {
    if (stretch.block >= count) break;
    ++pieces;
  }
  double const time = path_[pieces].start;
  double const whole = std::floor(time);
  double const passed = places_[count];
  double const oldest = time - monitor_.cycles_after();
  std::size_t first = 0;
  while (first < pieces && path_[first].end() < oldest - monitor_.cycles_before() - 1) ++first;
  path_.erase(path_.begin() + static_cast<std::ptrdiff_t>(pieces), path_.end());
  path_.erase(path_.begin(), path_.begin() + static_cast<std::ptrdiff_t>(first));
  if (first > 0) valid_from_ = oldest;
  for (auto& piece : path_) {
    piece.start -= whole;
    piece.place -= passed;
  }
  passed_pieces_ = path_.size();
  time_ = time - whole;
  valid_from_ -= whole;
  std::size_t const window_corner = passed_corners_ + count;
  std::size_t first_corner = window_corner;
  while (first_corner > 0 && corners_[first_corner].time > oldest) --first_corner;
  corners_.erase(corners_.begin(), corners_.begin() + static_cast<std::ptrdiff_t>(first_corner));
  passed_corners_ = window_corner - first_corner;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    corners_[i].place -= passed;
    corners_[i].time -= whole;
    corners_[i].passed = i < passed_corners_;
  }
}

}  // namespace axisc::motion
