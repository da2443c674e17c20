#include "motion/look_ahead.hpp"

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

}  // namespace

void LookAhead::begin(Point const& position, ToleranceMonitor monitor, double acceleration_factor) {
  position_ = position;
  monitor_ = constant_velocity_ ? ToleranceMonitor() : std::move(monitor);
  acceleration_factor_ = acceleration_factor;
}

void LookAhead::add(ProgrammedBlock const& block) {
  Point const way = minus(block.end, position_);
  double const distance = motion::length(way);
  if (!(distance > 0)) return;
  PathBlock added;
  added.begin = position_;
  added.end = block.end;
  added.direction = plus({}, 1 / distance, way);
  added.length = distance;
  added.velocity = std::min(block.feed, limits_.velocity(added.direction));
  added.acceleration = constant_velocity_ ? at_once : limits_.acceleration(added.direction);
  added.index = next_index_++;
  added.line = block.line;
  added.label = block.label;
  position_ = block.end;
  blocks_.push_back(std::move(added));
  if (blocks_.size() >= window) plan(window / 2, false);
}

void LookAhead::stop() {
  if (!blocks_.empty()) plan(blocks_.size(), true);
  last_block_ = {};
  velocity_ = 0;
  corners_.clear();
  passed_corners_ = 0;
}

void LookAhead::collect_corners() {
  corners_.resize(passed_corners_);
  places_.assign(1, 0);
  PathBlock before = last_block_;
  bool const moving = velocity_ > 0;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    auto const& block = blocks_[i];
    if (i > 0 || moving) {
      corners_.push_back({.place = places_.back(),
                          .before = before.direction,
                          .turn = minus(block.direction, before.direction),
                          .velocity_before = before.velocity,
                          .velocity_behind = block.velocity,
                          .acceleration_before = before.acceleration,
                          .acceleration_behind = block.acceleration,
                          .velocity = unlimited});
    }
    before = block;
    places_.push_back(places_.back() + block.length);
  }
  if (!monitor_.active()) return;
  for (std::size_t i = passed_corners_; i < corners_.size(); ++i) {
    corners_[i].velocity = monitor_.velocity(corners_, i);
  }
}

void LookAhead::cut_into_stretches() {
  cuts_ = places_;
  double const cycles = monitor_.plateau();
  for (auto const& corner : corners_) {
    if (corner.velocity == unlimited) continue;
    for (double const end :
         {corner.place - corner.velocity * cycles, corner.place + corner.velocity * cycles}) {
      if (end > 0 && end < places_.back()) cuts_.push_back(end);
    }
  }
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
                                      .acceleration = asked.acceleration},
                            .ends_block = ends_block});
      from = cut;
    }
    if (ends_block && block + 1 < blocks_.size()) ++block;
  }
}

void LookAhead::limit_by_plateaus() {
  double const cycles = monitor_.plateau();
  cuts_.clear();
  double place = 0;
  for (auto const& stretch : stretches_) cuts_.push_back(place += stretch.piece.length);
  for (auto const& corner : corners_) {
    if (corner.velocity == unlimited) continue;
    double const begin = corner.place - corner.velocity * cycles;
    double const end = corner.place + corner.velocity * cycles;
    auto at = static_cast<std::size_t>(std::upper_bound(cuts_.begin(), cuts_.end(), begin + no_length) -
                                       cuts_.begin());
    for (; at < stretches_.size() && cuts_[at] - stretches_[at].piece.length < end - no_length; ++at) {
      auto& piece = stretches_[at].piece;
      piece.velocity_limit = std::min(piece.velocity_limit, corner.velocity);
    }
  }
}

void LookAhead::choose_velocities() {
  std::size_t const count = stretches_.size();
  velocities_.assign(count + 1, unlimited);
  velocities_[count] = constant_velocity_ ? unlimited : 0;
  for (std::size_t i = 0; i < count; ++i) {
    double const limit = stretches_[i].piece.velocity_limit;
    velocities_[i] = std::min(velocities_[i], limit);
    velocities_[i + 1] = std::min(velocities_[i + 1], limit);
    if (!stretches_[i].ends_block || i + 1 == count || constant_velocity_) continue;
    auto const turn =
        minus(blocks_[stretches_[i + 1].block].direction, blocks_[stretches_[i].block].direction);
    velocities_[i + 1] = std::min(velocities_[i + 1], limits_.corner(turn, acceleration_factor_));
  }
  if (!constant_velocity_) velocities_[0] = velocity_;
  for (std::size_t i = count; i-- > 1;) {
    auto const& piece = stretches_[i].piece;
    double const next = velocities_[i + 1];
    velocities_[i] = std::min(velocities_[i], std::sqrt(next * next + 2 * piece.acceleration * piece.length));
  }
  for (std::size_t i = 0; i < count; ++i) {
    auto& piece = stretches_[i].piece;
    double const now = velocities_[i];
    velocities_[i + 1] =
        std::min(velocities_[i + 1], std::sqrt(now * now + 2 * piece.acceleration * piece.length));
    piece.velocity_in = now;
    piece.velocity_out = velocities_[i + 1];
  }
}

void LookAhead::plan(std::size_t handed_on, bool stops) {
  collect_corners();
  cut_into_stretches();
  if (monitor_.active()) limit_by_plateaus();
  choose_velocities();
  for (std::size_t i = 0; i < stretches_.size() && stretches_[i].block < handed_on; ++i) {
    auto const& stretch = stretches_[i];
    auto const& block = blocks_[stretch.block];
    sink_.piece(block, stretch.piece);
    if (!stretch.ends_block) continue;
    bool const last = stops && stretch.block + 1 == blocks_.size();
    sink_.block_end(block, last ? nullptr : &blocks_[stretch.block + 1]);
    velocity_ = stretch.piece.velocity_out;
  }
  last_block_ = blocks_[handed_on - 1];
  remember_corners(places_[handed_on]);
  blocks_.erase(blocks_.begin(), blocks_.begin() + static_cast<std::ptrdiff_t>(handed_on));
}

/// The tolerance may still look at them, and their plateaus may reach into the window.
void LookAhead::remember_corners(double passed) {
  std::vector<Corner> kept;
  for (auto& corner : corners_) {
    corner.place -= passed;
    if (corner.place < 0) kept.push_back(corner);
  }
  if (kept.size() > ToleranceMonitor::most_neighbours) {
    kept.erase(kept.begin(), kept.end() - static_cast<std::ptrdiff_t>(ToleranceMonitor::most_neighbours));
  }
  corners_ = std::move(kept);
  passed_corners_ = corners_.size();
}

}  // namespace axisc::motion
