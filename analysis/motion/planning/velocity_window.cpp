#include "analysis/motion/planning/velocity_window.hpp"

#include <algorithm>
#include <array>

namespace axisc::motion {
namespace {

/// Rounding of ways and velocities.
constexpr double window_rounding = 1e-12;

/// The highest velocity before an element with which it ends at `next`.
double highest_before(PathElement& element, double next) {
  return element.down->fastest(next, element.length, element.share);
}

}  // namespace

Exit exit_of(PathElement const& element, double velocity_in, double wanted) {
  if (wanted >= velocity_in) {
    return {std::min(wanted, element.up->fastest(velocity_in, element.length)), true};
  }
  if (element.down->way(wanted, velocity_in) <= element.length * (1 + window_rounding)) return {wanted, true};
  // The way of a small change is that of a difference of velocities, of which rounding leaves few digits.
  if (velocity_in <= element.down->fastest(wanted, element.length) * (1 + window_rounding)) {
    return {wanted, true};
  }
  double const slower = element.down->slowest(wanted, velocity_in, element.length);
  return {std::max(0.0, slower), slower >= 0};
}

LimitedBy cause_of(double velocity_out, PathElement const* next, bool waits_for_blocks, bool ends) {
  if (next == nullptr) return ends ? LimitedBy::stop : LimitedBy::look_ahead;
  if (velocity_out >= next->entry * (1 - window_rounding)) return next->entry_cause;
  if (velocity_out < next->allowed * (1 - window_rounding)) return LimitedBy::axis;
  return waits_for_blocks ? LimitedBy::look_ahead : LimitedBy::braking;
}

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
  complete(passed, middle_velocity(task_of(passed)));
}

void complete(PassedElement& passed, double middle) {
  passed.velocity_middle = middle;
  double const peak = std::max(passed.velocity_in, passed.velocity_middle);
  if (peak >= passed.element.velocity * (1 - window_rounding)) {
    passed.limited_by = passed.element.velocity_cause;
  }
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
  auto& last = elements_.back();
  double const braking = last.down->fastest(0, last.length);
  last.allowed = std::min(last.entry, braking);
  last.waits_for_blocks = braking < last.entry;
}

/// All of the first window. Where the path moves, each element was the last of a window before.
void VelocityWindow::prime(std::size_t end) {
  primed_ = true;
  pending_ = end;
  double next = 0;
  bool waits = true;
  for (std::size_t i = end; i-- > first_;) {
    auto& element = elements_[i];
    double braking = highest_before(element, next);
    if (moves_) braking = std::max(braking, element.allowed);
    element.waits_for_blocks = waits && braking < element.entry;
    element.allowed = std::min(element.entry, braking);
    next = element.allowed;
    waits = element.waits_for_blocks;
  }
}

/// V of one element from that of the next one. False where it stays.
bool VelocityWindow::raise_before(std::size_t next_at) {
  auto& element = elements_[next_at - 1];
  auto const& next = elements_[next_at];
  if (!(element.allowed < element.entry)) return false;
  double const braking = highest_before(element, next.allowed);
  double const found = std::min(element.entry, braking);
  if (!(found > element.allowed)) return false;
  element.allowed = found;
  element.waits_for_blocks = next.waits_for_blocks && braking < element.entry;
  return true;
}

/// Backwards from the last known element, as far as it changes something.
///
/// One V needs the other, and the processor waits for each. So where every pass comes here, the windows of
/// the next passes are followed backwards at the same time, each one element behind the one before it.
void VelocityWindow::raise(std::size_t end) {
  bool const is_usual = pending_ + 1 == end;
  std::size_t const windows = is_usual ? std::min(further_windows, elements_.size() - end) + 1 : 1;
  std::array<bool, further_windows + 1> ended{};
  std::size_t left = windows;
  // Window k lacks the first k elements, which are passed by then.
  for (std::size_t next_at = end - 1; next_at > first_ + 1 && left > 0; --next_at) {
    for (std::size_t k = 0; k < windows; ++k) {
      if (ended[k]) continue;
      bool const is_new = k == 0 && next_at - 1 >= pending_;
      if (raise_before(next_at + k) || is_new) continue;
      ended[k] = true;
      --left;
    }
  }
  pending_ = end + windows - 1;
}

/// Elements are moved only now and then.
void VelocityWindow::forget_passed() {
  constexpr std::size_t many = 1024;
  if (first_ < many || first_ < elements_.size() / 2) return;
  elements_.erase(elements_.begin(), elements_.begin() + static_cast<std::ptrdiff_t>(first_));
  pending_ -= std::min(pending_, first_);
  first_ = 0;
}

PassedElement VelocityWindow::pass(std::size_t known, bool ends) {
  std::size_t const end = first_ + known;
  if (!primed_) prime(end);
  PassedElement passed{.element = elements_[first_], .velocity_in = velocity_};
  auto const& element = passed.element;
  bool const is_last = known == 1;
  PathElement const* const next = is_last ? nullptr : &elements_[first_ + 1];
  // An earlier window may allow more than this element reaches.
  bool const is_pending = !is_last && pending_ < end && next->allowed < next->entry;
  if (is_pending && next->allowed < element.up->fastest(velocity_, element.length)) raise(end);
  auto const exit = exit_of(element, velocity_, is_last ? 0 : next->allowed);
  passed.velocity_out = exit.velocity;
  passed.is_possible = exit.is_possible;
  passed.waits_for_blocks = !ends && (is_last || next->waits_for_blocks);
  passed.limited_by = cause_of(passed.velocity_out, next, passed.waits_for_blocks, ends);
  velocity_ = passed.velocity_out;
  ++first_;
  forget_passed();
  return passed;
}

}  // namespace axisc::motion
