#include "motion/feed_limits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace axisc::motion {
namespace {

constexpr double steps_per_change = 8;
/// Between two steps a hump rises above them by less than this.
constexpr double next_to_hump = 0.8;

/// Radians per cycle within which a gain turns from one extreme to the next:  π over the length of the kernels.
double finest_change(std::span<ChainAnswer const> answers) {
  double length = 1;
  for (auto const& answer : answers) {
    length = std::max(length, 2 * answer.reach + 1 + std::abs(answer.delay - answers.front().delay));
  }
  return std::numbers::pi / length;
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

std::optional<double> circle_velocity(std::span<ChainAnswer const> answers, double radius, double tolerance) {
  auto const error = [&](double angle) {
    return predict_circle(answers, angle * radius, radius).largest_axis_error();
  };
  // Where the error is exceeded between these two.
  auto const bisected = [&](double low, double high) {
    for (int i = 0; i < 50; ++i) {
      double const middle = (low + high) / 2;
      (error(middle) <= tolerance ? low : high) = middle;
    }
    return low * radius;
  };
  double const step = finest_change(answers) / steps_per_change;
  double before = 0;
  double last = 0;
  for (int i = 1; (i - 1) * step < std::numbers::pi; ++i) {
    double const angle = std::min(i * step, std::numbers::pi);
    double const here = error(angle);
    if (here > tolerance) return bisected((i - 1) * step, angle);
    if (last >= before && last >= here && last > next_to_hump * tolerance) {
      double const top = highest_place(error, (i - 2) * step, angle);
      if (error(top) > tolerance) return bisected((i - 2) * step, top);
    }
    before = std::exchange(last, here);
  }
  return std::nullopt;
}

}  // namespace axisc::motion
