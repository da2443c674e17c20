#include "analysis/motion/velocity_window.hpp"

#include <algorithm>

namespace axisc::motion {
namespace {

/// Rounding of ways and velocities.
constexpr double same_way = 1e-12;
constexpr double same_velocity = 1e-12;

/// The highest velocity before an element with which it ends at `next`.
double highest_before(PathElement& element, double next) {
  return element.down->fastest(next, element.length, element.share);
}

/// Why an element does not end faster; `next` is what follows it.
LimitedBy cause_of(PassedElement const& passed, PathElement const* next, bool ends) {
  if (next == nullptr) return ends ? LimitedBy::stop : LimitedBy::look_ahead;
  if (passed.velocity_out >= next->entry * (1 - same_velocity)) return next->entry_cause;
  if (passed.velocity_out < next->allowed * (1 - same_velocity)) return LimitedBy::axis;
  return passed.waits_for_blocks ? LimitedBy::look_ahead : LimitedBy::braking;
}

}  // namespace

BlockTask task_of(PassedElement const& passed) {
  auto const& element = passed.element;
  return {.length = element.length,
          .velocity_in = passed.velocity_in,
          .velocity_out = passed.velocity_out,
          .limit = element.velocity,
          .up = element.up,
          .down = element.down};
}

void complete(PassedElement& passed) {
  passed.velocity_middle = middle_velocity(task_of(passed));
  double const peak = std::max(passed.velocity_in, passed.velocity_middle);
  if (peak >= passed.element.velocity * (1 - same_velocity))
    passed.limited_by = passed.element.velocity_cause;
}

void VelocityWindow::begin(double velocity, bool moves) {
  elements_.clear();
  first_ = pending_ = 0;
  velocity_ = velocity;
  moves_ = moves;
  primed_ = false;
}

void VelocityWindow::push(PathElement const& element) {
  elements_.push_back(element);
  if (!primed_) return;
  auto& last = elements_.back();
  double const braking = last.down->fastest(0, last.length);
  last.allowed = std::min(last.entry, braking);
  last.waits_for_blocks = braking < last.entry;
}

/// All of the first window.
void VelocityWindow::prime() {
  primed_ = true;
  pending_ = elements_.size();
  double next = 0;
  bool waits = true;
  for (std::size_t i = elements_.size(); i-- > first_;) {
    auto& element = elements_[i];
    double braking = highest_before(element, next);
    if (moves_) braking = std::max(braking, element.down->fastest(0, element.length));
    element.waits_for_blocks = waits && braking < element.entry;
    element.allowed = std::min(element.entry, braking);
    next = element.allowed;
    waits = element.waits_for_blocks;
  }
}

/// Backwards from the last element, as far as it changes something.
void VelocityWindow::raise() {
  for (std::size_t i = elements_.size() - 1; i-- > first_ + 1;) {
    auto& element = elements_[i];
    auto const& next = elements_[i + 1];
    bool changes = false;
    if (element.allowed < element.entry) {
      double const braking = highest_before(element, next.allowed);
      double const found = std::min(element.entry, braking);
      changes = found > element.allowed;
      if (changes) {
        element.allowed = found;
        element.waits_for_blocks = next.waits_for_blocks && braking < element.entry;
      }
    }
    if (!changes && i < pending_) break;
  }
  pending_ = elements_.size();
}

/// Elements are moved only now and then.
void VelocityWindow::forget_passed() {
  constexpr std::size_t many = 1024;
  if (first_ < many || first_ < elements_.size() / 2) return;
  elements_.erase(elements_.begin(), elements_.begin() + static_cast<std::ptrdiff_t>(first_));
  pending_ -= std::min(pending_, first_);
  first_ = 0;
}

PassedElement VelocityWindow::pass(bool ends) {
  if (!primed_) prime();
  PassedElement passed{.element = elements_[first_], .velocity_in = velocity_};
  auto const& element = passed.element;
  bool const is_last = size() == 1;
  PathElement const* const next = is_last ? nullptr : &elements_[first_ + 1];
  double const reached = element.up->fastest(velocity_, element.length);
  if (!is_last && pending_ < elements_.size() && next->allowed < std::min(reached, next->entry)) raise();
  double const wanted = is_last ? 0 : next->allowed;
  passed.waits_for_blocks = !ends && (is_last || next->waits_for_blocks);
  if (wanted >= velocity_) {
    passed.velocity_out = std::min(wanted, reached);
  } else if (element.down->way(wanted, velocity_) <= element.length * (1 + same_way)) {
    passed.velocity_out = wanted;
  } else {
    double const slower = element.down->slowest(wanted, velocity_, element.length);
    passed.is_possible = slower >= 0;
    passed.velocity_out = std::max(0.0, slower);
  }
  passed.limited_by = cause_of(passed, next, ends);
  velocity_ = passed.velocity_out;
  ++first_;
  forget_passed();
  return passed;
}

}  // namespace axisc::motion
