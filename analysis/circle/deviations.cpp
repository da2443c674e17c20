#include "analysis/circle/deviations.hpp"

#include "analysis/circle/circle_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace axisc::circle {

namespace {

/// Every 0.1°, halfway between multiples of it: where an axis reverses, its path jumps by the backlash, at an
/// angle that depends on the last sample before it.
constexpr int compared_angles = 3600;

struct Range {
  double low = HUGE_VAL, high = -HUGE_VAL;
  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

Range distances(std::span<Sample const> samples, double u, double v) {
  Range range;
  for (auto const& each : samples) range.take(std::hypot(each.u - u, each.v - v));
  return range;
}

double circular_deviation(std::span<Sample const> samples, FittedCircle const& circle) {
  auto const range = distances(samples, circle.u, circle.v);
  return range.high - range.low;
}

/// Distances by angle, once around and a bit more on both sides.
class Profile {
 public:
  Profile(Turn const& turn, FittedCircle const& about) {
    points_.reserve(turn.samples.size() + 2);
    for (auto const& each : turn.samples) {
      double const u = each.u - about.u;
      double const v = each.v - about.v;
      points_.emplace_back(std::atan2(v, u), std::hypot(u, v));
    }
    std::sort(points_.begin(), points_.end());
    auto const [first, last] = std::pair(points_.front(), points_.back());
    points_.insert(points_.begin(), {last.first - 2 * std::numbers::pi, last.second});
    points_.emplace_back(first.first + 2 * std::numbers::pi, first.second);
  }

  [[nodiscard]] double at(double angle) const {
    auto const next = std::upper_bound(points_.begin() + 1, points_.end() - 1, std::pair(angle, HUGE_VAL));
    auto const& [angle1, value1] = *next;
    auto const& [angle0, value0] = *(next - 1);
    double const step = angle1 - angle0;
    return step > 0 ? value0 + (value1 - value0) * (angle - angle0) / step : value0;
  }

 private:
  std::vector<std::pair<double, double>> points_;
};

}  // namespace

Deviations deviations_of(std::span<Turn const> turns, double radius) {
  Deviations found;
  Range all;
  std::vector<Sample> both;
  for (auto const& turn : turns) {
    auto const own = distances(turn.samples, 0, 0);
    all.take(own.low);
    all.take(own.high);
    auto& deviation = turn.sense == Sense::counterclockwise ? found.counterclockwise : found.clockwise;
    deviation = circular_deviation(turn.samples, fit_circle(turn.samples));
    both.insert(both.end(), turn.samples.begin(), turn.samples.end());
  }
  found.radial_max = all.high - radius;
  found.radial_min = all.low - radius;
  if (turns.size() < 2) return found;
  auto const common = fit_circle(both);
  found.bidirectional = circular_deviation(both, common);
  found.mean_radial = common.radius - radius;
  Profile const first(turns[0], common);
  Profile const second(turns[1], common);
  found.hysteresis = 0;
  for (int i = 0; i < compared_angles; ++i) {
    double const angle = (i + 0.5) * 2 * std::numbers::pi / compared_angles - std::numbers::pi;
    found.hysteresis = std::max(*found.hysteresis, std::abs(first.at(angle) - second.at(angle)));
  }
  return found;
}

}  // namespace axisc::circle
