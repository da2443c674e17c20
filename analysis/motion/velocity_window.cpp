#include "analysis/motion/velocity_window.hpp"

#include <algorithm>

namespace axisc::motion {
namespace {

/// Rounding of ways and velocities.
constexpr double same_way = 1e-12;
constexpr double same_velocity = 1e-12;

/// The highest velocity before an element with which it ends at `next`.
double highest_before(PathElement const& element, double next) {
  return element.down->fastest(next, element.length);
}

/// Why an element is not passed faster; `next` is what follows it.
LimitedBy cause_of(PassedElement const& passed, PathElement const* next, bool ends) {
  auto const& element = passed.element;
  double const peak = std::max(passed.velocity_in, passed.velocity_middle);
  if (peak >= element.velocity * (1 - same_velocity)) return element.velocity_cause;
  if (next == nullptr) return ends ? LimitedBy::stop : LimitedBy::look_ahead;
  if (passed.velocity_out >= next->entry * (1 - same_velocity)) return next->entry_cause;
  if (passed.velocity_out < next->allowed * (1 - same_velocity)) return LimitedBy::axis;
  return passed.waits_for_blocks ? LimitedBy::look_ahead : LimitedBy::braking;
}

}  // namespace

BlockTask task_of(PathElement const& element, double velocity_in, double velocity_out) {
  return {.length = element.length,
          .velocity_in = velocity_in,
          .velocity_out = velocity_out,
          .limit = element.velocity,
          .up = element.up,
          .down = element.down};
}

void VelocityWindow::begin(double velocity, bool moves) {
  elements_.clear();
  velocity_ = velocity;
  moves_ = moves;
  primed_ = false;
}

void VelocityWindow::push(PathElement const& element) {
  elements_.push_back(element);
  if (primed_) raise();
}

/// All of the first window.
void VelocityWindow::prime() {
  primed_ = true;
  double next = 0;
  bool waits = true;
  for (std::size_t i = elements_.size(); i-- > 0;) {
    auto& element = elements_[i];
    double braking = highest_before(element, next);
    if (moves_) braking = std::max(braking, highest_before(element, 0));
    element.waits_for_blocks = waits && braking < element.entry;
    element.allowed = std::min(element.entry, braking);
    next = element.allowed;
    waits = element.waits_for_blocks;
  }
}

/// Backwards from a new last element, as far as it changes something.
void VelocityWindow::raise() {
  double next = 0;
  bool waits = true;
  for (std::size_t i = elements_.size(); i-- > 1;) {
    auto& element = elements_[i];
    double const braking = highest_before(element, next);
    double const found = std::min(element.entry, braking);
    if (found <= element.allowed) break;
    element.allowed = found;
    element.waits_for_blocks = waits && braking < element.entry;
    next = found;
    waits = element.waits_for_blocks;
  }
}

PassedElement VelocityWindow::pass(bool ends) {
  if (!primed_) prime();
  PassedElement passed{.element = elements_.front(), .velocity_in = velocity_};
  auto const& element = passed.element;
  bool const is_last = elements_.size() == 1;
  PathElement const* const next = is_last ? nullptr : &elements_[1];
  double const wanted = is_last ? 0 : next->allowed;
  passed.waits_for_blocks = !ends && (is_last || next->waits_for_blocks);
  if (wanted >= velocity_) {
    passed.velocity_out = std::min(wanted, element.up->fastest(velocity_, element.length));
  } else if (element.down->way(wanted, velocity_) <= element.length * (1 + same_way)) {
    passed.velocity_out = wanted;
  } else {
    double const slower = element.down->slowest(wanted, velocity_, element.length);
    passed.is_possible = slower >= 0;
    passed.velocity_out = std::max(0.0, slower);
  }
  passed.velocity_middle = middle_velocity(task_of(element, velocity_, passed.velocity_out));
  passed.limited_by = cause_of(passed, next, ends);
  velocity_ = passed.velocity_out;
  elements_.pop_front();
  return passed;
}

}  // namespace axisc::motion
