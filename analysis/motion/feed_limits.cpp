#include "analysis/motion/feed_limits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axisc::motion {
namespace {

constexpr double steps_per_change = 8;
constexpr int halvings = 50;
/// Between two steps a hump rises above them by less than this.
constexpr double next_to_hump = 0.8;

/// Radians per cycle within which a gain turns from one extreme to the next:  π over the length of the
/// kernels.
double finest_change(std::span<ChainAnswer const> answers) {
  double length = 1;
  for (auto const& answer : answers) {
    length = std::max(length, 2 * answer.reach + 1 + std::abs(answer.delay - answers.front().delay));
  }
  return std::numbers::pi / length;
}

/// No axis is farther from a circle of radius 1 than the path: by 1, or, as no component becomes larger than
/// the sum P of the magnitudes of its taps, by  √2 P - 1.
double largest_error(std::span<ChainAnswer const> answers) {
  double most = 1;
  for (auto const& answer : answers) {
    double sum = 0;
    for (std::size_t n = 0; n < answer.tap_count(); ++n) sum += std::abs(answer.tap(n));
    most = std::max(most, std::numbers::sqrt2 * sum - 1);
  }
  return most;
}

/// Where a function with one hump between two places is highest, by the golden section.
template <class Function>
double highest_place(Function const& function, double low, double high) {
  double const share = (std::sqrt(5.0) - 1) / 2;
  for (int i = 0; i < 40; ++i) {
    double const first = high - share * (high - low);
    double const second = low + share * (high - low);
    (function(first) < function(second) ? low : high) = function(first) < function(second) ? first : second;
  }
  return (low + high) / 2;
}

}  // namespace

std::optional<double> corner_velocity(std::span<ChainAnswer const> answers, double turn, double tolerance) {
  double const per_velocity = predict_corner(answers, 1, turn).largest_axis_error();
  if (per_velocity < 1e-9) return std::nullopt;
  return tolerance / per_velocity;
}

CircleVelocities::CircleVelocities(std::span<ChainAnswer const> answers)
    : answers_(answers),
      step_(finest_change(answers) / steps_per_change),
      most_(largest_error(answers)),
      errors_{0},
      highest_{0} {}

double CircleVelocities::error(double angle) const {
  return largest_circle_error(answers_, std::min(angle, std::numbers::pi), 1);
}

/// Between two steps there may be a hump that is higher than both.
void CircleVelocities::look_further() {
  auto const i = errors_.size();
  double const here = error(static_cast<double>(i) * step_);
  double highest = std::max(highest_.back(), here);
  double const last = errors_[i - 1];
  bool const is_hump = i >= 2 && last >= errors_[i - 2] && last >= here;
  if (is_hump && last > next_to_hump * highest) {
    auto const function = [this](double angle) { return error(angle); };
    double const from = static_cast<double>(i - 2) * step_;
    highest = std::max(highest, error(highest_place(function, from, static_cast<double>(i) * step_)));
    highest_.back() = std::max(highest_.back(), highest);
  }
  errors_.push_back(here);
  highest_.push_back(highest);
}

std::optional<double> CircleVelocities::highest(double radius, double tolerance) {
  double const share = tolerance / radius;
  if (share >= most_) return std::nullopt;
  double const last = std::numbers::pi / step_;
  // A hump is seen only from the step after it.
  while (highest_[highest_.size() - std::min<std::size_t>(2, highest_.size())] <= share &&
         static_cast<double>(highest_.size()) < last + 2) {
    look_further();
  }
  auto const exceeded = std::upper_bound(highest_.begin(), highest_.end(), share);
  if (exceeded == highest_.end()) return std::nullopt;
  double const to = static_cast<double>(exceeded - highest_.begin()) * step_;
  double low = to - step_;
  double high = to;
  if (error(to) <= share) {
    // The top of the hump lies on either side of this step.
    high = highest_place([this](double angle) { return error(angle); }, low, to + step_);
    if (error(high) <= share) return low * radius;
  }
  for (int i = 0; i < halvings; ++i) {
    double const middle = (low + high) / 2;
    (error(middle) <= share ? low : high) = middle;
  }
  return low * radius;
}

std::optional<double> circle_velocity(std::span<ChainAnswer const> answers, double radius, double tolerance) {
  return CircleVelocities(answers).highest(radius, tolerance);
}

}  // namespace axisc::motion
