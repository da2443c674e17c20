#include "analysis/motion/look_ahead.hpp"

#include "analysis/motion/planning/junction.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axisc::motion {
namespace {

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
    std::size_t const held = window_ + VelocityWindow::further_windows;
    if (blocks_.size() >= (constant_velocity_ ? shortest_window : held)) pass_block();
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
    while (!blocks_.empty()) pass_block();
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
void LookAhead::pass_block() {
  auto const& block = blocks_.front();
  PathBlock const* const next = blocks_.size() > 1 ? &blocks_[1] : nullptr;
  BlockMotion motion{block.velocity, block.velocity, block.velocity, block.velocity_cause};
  phases_.clear();
  if (constant_velocity_) {
    phases_.push_back(Phase::steady(block.velocity, block.length));
  } else {
    auto passed = velocities_.pass(std::min(window_, blocks_.size()), blocks_.size() < window_);
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
  full_ = blocks_.size() + hsc_window - hsc_ahead;
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
