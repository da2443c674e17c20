#include "motion/feed_limits.hpp"

namespace axisc::motion {

std::optional<double> corner_velocity(std::span<ChainAnswer const> answers, double turn, double tolerance) {
  double const per_velocity = predict_corner(answers, 1, turn).largest_axis_error();
  if (per_velocity < 1e-9) return std::nullopt;
  return tolerance / per_velocity;
}

std::optional<double> circle_velocity(std::span<ChainAnswer const> answers, double radius, double tolerance) {
  auto const keeps = [&](double velocity) {
    return predict_circle(answers, velocity, radius).largest_axis_error() <= tolerance;
  };
  // Upwards first: behind its first zero the gain of a kernel rises again.
  double low = 0;
  double high = radius * 1e-6;
  while (keeps(high)) {
    low = high;
    high *= 1.25;
    if (high > radius / 2) return std::nullopt;
  }
  for (int i = 0; i < 50; ++i) {
    double const middle = (low + high) / 2;
    (keeps(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace axisc::motion
