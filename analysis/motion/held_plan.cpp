// Plans of the blocks that are held: corners, elements, velocities, times.
#include "analysis/motion/look_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace axisc::motion {
namespace {

/// Position units: shorter stretches are nothing but rounding.
constexpr double no_length = 1e-9;
/// A smaller change of direction comes from rounded end points.
constexpr double no_turn = 1e-12;

}  // namespace

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
    auto passed = velocities_.pass(velocities_.size(), ends);
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

/// Across the ends of blocks. Where there is no place before the end, there is one in the middle.
void LookAhead::plan_stretches(bool ends) {
  auto const settled = blocks_.size() - std::min(blocks_.size(), hsc_ahead);
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
    if (!is_early(part) || (place > 0 && element.block >= settled)) continue;
    place = element.block + 1;
    pieces = pieces_.size();
  }
  touched_ = pieces;
  settled_blocks_ = place;
}

}  // namespace axisc::motion
