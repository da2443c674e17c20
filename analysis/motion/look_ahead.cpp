#include "analysis/motion/look_ahead.hpp"

#include "analysis/motion/planning/junction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace axisc::motion {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
/// Position units: shorter stretches are nothing but rounding.
constexpr double no_length = 1e-9;
/// A smaller change of direction comes from rounded end points.
constexpr double no_turn = 1e-12;
constexpr std::size_t shortest_window = 2;

}  // namespace

LookAhead::LookAhead(PathLimits limits, bool constant_velocity, PathSink& sink)
    : limits_(std::move(limits)),
      constant_velocity_(constant_velocity),
      sink_(sink),
      window_(std::max<std::size_t>(shortest_window, limits_.dynamics().channel.look_ahead_blocks)) {}

void LookAhead::begin(Point const& position, ToleranceMonitor monitor, double acceleration_factor) {
  position_ = position;
  monitor_ = constant_velocity_ ? ToleranceMonitor() : std::move(monitor);
  limits_.set_acceleration_factor(acceleration_factor);
  forget();
}

void LookAhead::add(ProgrammedBlock const& block) {
  double const distance = block.arc ? block.arc->length : motion::length(minus(block.end, position_));
  if (!(distance > 0)) return;
  PathBlock const* const before = blocks_.empty() ? nullptr : &blocks_.back();
  bool const begins_faster = before != nullptr && before->brakes_late;
  double const most = block.arc ? tolerated(*block.arc) : unlimited;
  auto& added = blocks_.emplace_back(limits_.block(block, position_, distance, most, begins_faster));
  added.index = next_index_++;
  position_ = block.end;
  auto const limit = before != nullptr ? junction_limit(*before, added) : JunctionLimit{added.velocity};
  asked_.push_back({.length = added.length,
                    .velocity = added.velocity,
                    .velocity_cause = added.velocity_cause,
                    .entry = limit.velocity,
                    .entry_cause = limit.cause,
                    .up = &added.up,
                    .down = &added.down,
                    .across = added.mode->across_blocks});
  if (added.mode->across_blocks && !constant_velocity_ && !std::exchange(is_across_, true)) {
    if (!monitor_.active()) full_ = hsc_window;
  }
  if (holds_blocks()) {
    if (blocks_.size() >= full_) plan(false);
  } else {
    if (!constant_velocity_) velocities_.push(asked_.back());
    if (blocks_.size() >= (constant_velocity_ ? shortest_window : window_)) pass_block(false);
  }
  if (!block.exact_stop) return;
  stop();
  sink_.exact_stop(last_block_);
}

/// The velocity at which a circle keeps the tolerance long after its beginning; its beginning and end are
/// tried.
double LookAhead::tolerated(Arc const& arc) {
  return monitor_.active() ? monitor_.velocity_on(arc.curvature_radius()) : unlimited;
}

void LookAhead::stop() {
  if (holds_blocks()) {
    if (!blocks_.empty()) plan(true);
  } else {
    while (!blocks_.empty()) pass_block(true);
  }
  forget();
}

/// The path rests, and nothing before it counts any more.
void LookAhead::forget() {
  velocity_ = 0;
  velocities_.begin(0, false);
  is_across_ = false;
  full_ = 2 * window_;
  corners_.clear();
  has_end_corner_ = false;
  passed_corners_ = 0;
  path_.clear();
  passed_pieces_ = 0;
  time_ = valid_from_ = 0;
  kept_.clear();
  kept_motions_.clear();
}

/// Hands on the first block, which ends in the next one or where the path stops.
void LookAhead::pass_block(bool ends) {
  auto const& block = blocks_.front();
  PathBlock const* const next = blocks_.size() > 1 ? &blocks_[1] : nullptr;
  BlockMotion motion{block.velocity, block.velocity, block.velocity, block.velocity_cause};
  phases_.clear();
  if (constant_velocity_) {
    phases_.push_back(Phase::steady(block.velocity, block.length));
  } else {
    auto passed = velocities_.pass(ends);
    complete(passed);
    append_profile(task_of(passed), passed.velocity_middle, phases_);
    motion = {passed.velocity_in, std::max(passed.velocity_in, passed.velocity_middle), passed.velocity_out,
              passed.limited_by};
  }
  for (auto const& phase : phases_) sink_.piece(block, phase);
  sink_.block_end(block, next, motion);
  velocity_ = motion.velocity_out;
  last_block_ = std::move(blocks_.front());
  blocks_.pop_front();
  asked_.pop_front();
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

/// Corners of blocks that were held already keep what is known about them.
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
    Point const turn = moves ? minus(block.direction_in(), before.direction_out()) : Point{};
    bool const is_sharp =
        std::any_of(turn.begin(), turn.end(), [](double u) { return std::abs(u) > no_turn; });
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

void LookAhead::cut_into_elements() {
  cuts_ = places_;
  for_each_plateau([this](double from, double to, double /*velocity*/, std::size_t /*corner*/) {
    for (double const end : {from, to}) {
      if (end > 0 && end < places_.back()) cuts_.push_back(end);
    }
  });
  std::sort(cuts_.begin(), cuts_.end());
  elements_.clear();
  std::size_t block = 0;
  double from = 0;
  bool begins_block = true;
  for (double const cut : cuts_) {
    bool const ends_block = cut == places_[block + 1];
    if (cut - from > no_length || ends_block) {
      auto& element = elements_.emplace_back(asked_[block]);
      element.block = block;
      element.length = std::max(0.0, cut - from);
      element.ends_block = ends_block;
      if (!begins_block) element.entry = element.velocity;
      begins_block = ends_block;
      from = cut;
    }
    if (ends_block && block + 1 < blocks_.size()) ++block;
  }
}

void LookAhead::limit_by_plateaus() {
  slowed_for_stop_ = elements_.size();
  cuts_.clear();
  double place = 0;
  for (auto const& element : elements_) cuts_.push_back(place += element.length);
  for_each_plateau([this](double begin, double end, double velocity, std::size_t corner) {
    bool const is_for_stop = corner + 1 == corners_.size();
    auto at = static_cast<std::size_t>(std::upper_bound(cuts_.begin(), cuts_.end(), begin + no_length) -
                                       cuts_.begin());
    for (; at < elements_.size() && cuts_[at] - elements_[at].length < end - no_length; ++at) {
      auto& element = elements_[at];
      if (!(element.velocity > velocity)) continue;
      element.velocity = velocity;
      element.velocity_cause = LimitedBy::tolerance;
      if (is_for_stop) slowed_for_stop_ = std::min(slowed_for_stop_, at);
    }
  });
  auto const lower = [](PathElement& element, PathElement const& by) {
    if (by.velocity_cause != LimitedBy::tolerance || !(by.velocity < element.entry)) return;
    element.entry = by.velocity;
    element.entry_cause = LimitedBy::tolerance;
  };
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    lower(elements_[i], elements_[i]);
    if (i > 0) lower(elements_[i], elements_[i - 1]);
  }
}

/// An element with its phases; those of a block add up.
void LookAhead::take(PassedElement const& passed, std::vector<Phase> const& phases) {
  auto const block = passed.element.block;
  double const peak = std::max(passed.velocity_in, passed.velocity_middle);
  if (block >= motions_.size()) {
    motions_.push_back({passed.velocity_in, peak, passed.velocity_out, passed.limited_by});
  } else {
    auto& motion = motions_[block];
    if (peak > motion.velocity_peak || passed.limited_by == LimitedBy::tolerance) {
      motion.limited_by = passed.limited_by;
    }
    motion.velocity_peak = std::max(motion.velocity_peak, peak);
    motion.velocity_out = passed.velocity_out;
  }
  for (auto const& phase : phases) pieces_.push_back({.block = block, .phase = phase, .ends_block = false});
  if (!passed.element.ends_block) return;
  bool const has_piece = !pieces_.empty() && pieces_.back().block == block;
  if (!has_piece) pieces_.push_back({.block = block, .phase = {}, .ends_block = false});
  pieces_.back().ends_block = true;
}

/// As the control would, with what it knows of the program when each block begins.
void LookAhead::choose_velocities(bool ends) {
  velocities_.begin(velocity_, velocity_ > 0);
  std::size_t pushed = 0;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    std::size_t const known = elements_[i].block + window_;
    while (pushed < elements_.size() && elements_[pushed].block < known) {
      velocities_.push(elements_[pushed++]);
    }
    auto passed = velocities_.pass(ends);
    complete(passed);
    bool const would_change = passed.waits_for_blocks && known > blocks_.size();
    if (would_change || i + 1 >= slowed_for_stop_) touched_ = std::min(touched_, pieces_.size());
    feasible_ = feasible_ && passed.is_possible;
    phases_.clear();
    append_profile(task_of(passed), passed.velocity_middle, phases_);
    take(passed, phases_);
  }
}

void LookAhead::make_plan(bool ends) {
  cut_into_elements();
  limit_by_plateaus();
  pieces_.clear();
  motions_.clear();
  touched_ = std::numeric_limits<std::size_t>::max();
  feasible_ = true;
  if (is_across_) return plan_stretches(ends);
  choose_velocities(ends);
}

/// When the plan passes its pieces and corners.
void LookAhead::time_plan() {
  path_.resize(passed_pieces_);
  double time = time_;
  double within = 0;  // the block
  for (auto const& piece : pieces_) {
    auto const& block = blocks_[piece.block];
    if (within == 0) corners_[passed_corners_ + piece.block].time = time;
    TimedPiece timed;
    timed.path = block.path;
    timed.from = within;
    timed.length = piece.phase.length;
    timed.phase = piece.phase;
    timed.place = places_[piece.block] + within;
    timed.start = time;
    timed.duration = piece.phase.duration;
    timed.ends_block = piece.ends_block;
    time += timed.duration;
    within = piece.ends_block ? 0 : within + timed.length;
    path_.push_back(timed);
  }
  corners_.back().time = time;
}

/// One cycle more for each end, which need not lie on one.
bool LookAhead::is_too_long() const {
  return !(path_.back().end() - time_ <= sink_.room() + 2);
}

/// Plans until the tolerance is kept. False where it cannot be.
bool LookAhead::keep_tolerance(bool ends) {
  for (int round = 0; feasible_; ++round) {
    time_plan();
    if (is_too_long()) return true;
    auto const verdict = monitor_.judge({.pieces = path_, .valid_from = valid_from_}, corners_, round);
    if (verdict == ToleranceMonitor::Verdict::keeps) return true;
    bool const is_lost = verdict != ToleranceMonitor::Verdict::changed;
    if (is_lost && !kept_.empty()) return false;
    // All of it is as slow as it may be; the simulation's measurement has the last word.
    if (verdict == ToleranceMonitor::Verdict::exceeds) return true;
    make_plan(ends);
  }
  // From rest every plan is possible, but for rounding.
  return kept_.empty();
}

/// Blocks that end so early that no later plan changes what is measured on them.
std::size_t LookAhead::untouched_blocks() const {
  auto const touched = std::min(touched_, pieces_.size() - 1);
  double const end = path_[passed_pieces_ + touched].start - monitor_.cycles_after();
  std::size_t count = 0;
  for (std::size_t i = 0; i < touched; ++i) {
    if (!pieces_[i].ends_block) continue;
    if (path_[passed_pieces_ + i].end() > end) break;
    count = pieces_[i].block + 1;
  }
  return std::min(count, blocks_.size() - 1);
}

/// Across the ends of blocks. What follows the last place in the first half may still change. Where there is
/// no place before the end, there is one in the middle.
void LookAhead::plan_stretches(bool ends) {
  auto parts = motion::plan_stretches(elements_, velocity_, ends);
  auto const is_early = [&](StretchPart const& part) {
    auto const& element = part.passed.element;
    return part.is_place && element.ends_block && element.block + 1 < blocks_.size();
  };
  if (!ends && blocks_.size() > 1 && std::none_of(parts.begin(), parts.end(), is_early)) {
    auto const middle = std::find_if(elements_.begin(), elements_.end(), [&](PathElement const& element) {
      return element.block == blocks_.size() / 2;
    });
    parts = motion::plan_stretches(elements_, velocity_, ends,
                                   static_cast<std::size_t>(middle - elements_.begin()));
  }
  std::size_t place = 0;
  std::size_t pieces = 0;
  for (auto const& part : parts) {
    feasible_ = feasible_ && part.passed.is_possible;
    take(part.passed, part.phases);
    auto const& element = part.passed.element;
    if (!part.is_place || !element.ends_block) continue;
    pieces_.back().is_place = true;
    if (!is_early(part) || (place > 0 && element.block >= blocks_.size() / 2)) continue;
    place = element.block + 1;
    pieces = pieces_.size();
  }
  touched_ = pieces;
  settled_blocks_ = place;
}

void LookAhead::plan(bool stops) {
  while (!blocks_.empty()) {
    collect_corners();
    make_plan(stops);
    if (!monitor_.active()) {
      plan_across(stops);
      if (stops) continue;
      return;
    }
    if (!keep_tolerance(stops)) {
      drive_kept_plan();
      continue;
    }
    if (stops || is_too_long()) {
      hand_on(blocks_.size(), true);
      return;
    }
    auto const count = untouched_blocks();
    full_ = std::max(blocks_.size() - count + window_, 2 * window_);
    if (count > 0) hand_on(count, false);
    return;
  }
}

/// Without tolerance. Where no plan goes on from here, the last one does up to its next place.
void LookAhead::plan_across(bool stops) {
  bool const is_lost = !feasible_ && !kept_.empty();
  std::size_t count = stops ? blocks_.size() : settled_blocks_;
  if (is_lost) {
    pieces_ = kept_;
    motions_ = kept_motions_;
    auto const place =
        std::find_if(pieces_.begin(), pieces_.end(), [](auto const& each) { return each.is_place; });
    count = place == pieces_.end() ? motions_.size() : place->block + 1;
  }
  hand_on(count, count == blocks_.size());
  full_ = blocks_.size() + hsc_window / 2;
}

void LookAhead::hand_on(std::size_t count, bool stops) {
  std::size_t i = 0;
  for (; i < pieces_.size() && pieces_[i].block < count; ++i) {
    auto const& piece = pieces_[i];
    auto const& block = blocks_[piece.block];
    if (piece.phase.duration > 0) sink_.piece(block, piece.phase);
    if (!piece.ends_block) continue;
    bool const last = stops && piece.block + 1 == blocks_.size();
    sink_.block_end(block, last ? nullptr : &blocks_[piece.block + 1], motions_[piece.block]);
    velocity_ = motions_[piece.block].velocity_out;
  }
  // Where the path stops, nothing is left to look back at.
  if (!stops) {
    kept_.assign(pieces_.begin() + static_cast<std::ptrdiff_t>(i), pieces_.end());
    for (auto& piece : kept_) piece.block -= count;
    kept_motions_.assign(motions_.begin() + static_cast<std::ptrdiff_t>(count), motions_.end());
    if (monitor_.active()) remember(count);
  }
  drop_blocks(count);
  if (stops) forget();
}

void LookAhead::drop_blocks(std::size_t count) {
  last_block_ = blocks_[count - 1];
  blocks_.erase(blocks_.begin(), blocks_.begin() + static_cast<std::ptrdiff_t>(count));
  asked_.erase(asked_.begin(), asked_.begin() + static_cast<std::ptrdiff_t>(count));
}

/// The rest of the last plan that kept the tolerance, until the filters have settled where it stops.
void LookAhead::drive_kept_plan() {
  std::size_t const count = kept_motions_.size();
  for (auto const& piece : kept_) {
    auto const& block = blocks_[piece.block];
    if (piece.phase.duration > 0) sink_.piece(block, piece.phase);
    if (!piece.ends_block) continue;
    bool const last = piece.block + 1 == count;
    sink_.block_end(block, last ? nullptr : &blocks_[piece.block + 1], kept_motions_[piece.block]);
  }
  drop_blocks(count);
  sink_.rest(last_block_, static_cast<std::uint64_t>(monitor_.cycles_before() + monitor_.cycles_after()));
  forget();
  // Those that are left begin at rest.
  if (!asked_.empty()) asked_.front().entry = asked_.front().velocity;
  for (auto const& block : blocks_) is_across_ = is_across_ || block.mode->across_blocks;
}

/// Keeps the part of the path that the next plan looks back at: times count from the last whole cycle, places
/// from the blocks that are held.
void LookAhead::remember(std::size_t count) {
  std::size_t pieces = passed_pieces_;
  for (auto const& piece : pieces_) {
    if (piece.block >= count) break;
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
