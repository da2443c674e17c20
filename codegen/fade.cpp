#include "codegen/fade.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace axisc::codegen {

MotionLimits motion_limits(double velocity_limit, double acceleration_limit, design::CycleTime cycle_time) {
  double const T = cycle_time.seconds();
  return {.velocity = velocity_limit * 10 * T, .acceleration = acceleration_limit * 1e4 * T * T};
}

std::uint32_t fade_cycles(double distance, MotionLimits const& limits) {
  if (!(limits.velocity > 0) || !(limits.acceleration > 0)) return 0;
  // F² - 15 L F - (40/√3) L v/a >= 0; its root fulfils the first condition, F >= 7.5 L, as well.
  double const half = 7.5 * distance;
  double const constant = 40 / std::sqrt(3.0) * distance * (limits.velocity / limits.acceleration);
  double const cycles = std::ceil(half + std::sqrt(half * half + constant));
  if (!(cycles <= longest_fade)) return 0;
  return std::max(static_cast<std::uint32_t>(cycles), 1U);
}

double tail_distance(design::KernelDesign const* a, design::KernelDesign const* b) {
  static std::vector<double> const none;
  std::vector<double> const& tails_a = a != nullptr ? a->tail_sums : none;
  std::vector<double> const& tails_b = b != nullptr ? b->tail_sums : none;
  double distance = 0;
  for (std::size_t j = 0; j < std::max(tails_a.size(), tails_b.size()); ++j) {
    double const tail_a = j < tails_a.size() ? tails_a[j] : 0;
    double const tail_b = j < tails_b.size() ? tails_b[j] : 0;
    distance += std::abs(tail_a - tail_b);
  }
  return distance;
}

}  // namespace axisc::codegen
