#include "analysis/circle/turn.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axisc::circle {

void weigh(std::vector<Sample>& samples, std::vector<double> const& angles) {
  std::size_t const count = samples.size();
  double const sign = angles.back() < angles.front() ? -1 : 1;
  // What lies more than a turn before the last position.
  double const before = std::abs(angles.back() - angles.front()) - 2 * std::numbers::pi;
  for (std::size_t i = 0; i < count; ++i) {
    double const from = angles[i == 0 ? 0 : i - 1];
    double const to = angles[std::min(i + 1, count - 1)];
    samples[i].weight = std::max(0.0, sign * (to - from) / 2 - (i == 0 ? before : 0.0));
  }
}

}  // namespace axisc::circle
