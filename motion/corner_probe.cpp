#include "motion/corner_probe.hpp"

#include "motion/nearest_point.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::motion {
namespace {

/// Points of the contour that are looked at on either side of the corner.
constexpr double points_aside = 24;

/// Way within x cycles from velocity v on, with acceleration a up to a highest velocity:  v x + a x²/2.
double ramp_way(double v, double a, double highest, double x) {
  double const rising = a > 0 ? std::clamp((highest - v) / a, 0.0, x) : 0;
  double const reached = v + a * rising;
  return (v + reached) / 2 * rising + reached * (x - rising);
}

}  // namespace

double plateau_cycles(std::span<ChainAnswer const> answers) {
  double reach = 0;
  for (auto const& answer : answers) reach = std::max(reach, answer.reach);
  return reach + 1;
}

CornerProbe::CornerProbe(GroupRuntime& runtime, std::span<ChainAnswer const> answers)
    : runtime_(&runtime), reach_(std::ceil(plateau_cycles(answers))) {
  for (auto const& answer : answers) delay_ = std::max(delay_, std::round(answer.delay));
}

Point CornerProbe::nominal(Corner const& corner, double plateau, double tau) const {
  double const x = std::abs(tau);
  double way = plateau * std::min(x, reach_);
  bool const behind = tau > 0;
  if (x > reach_) {
    way += behind ? ramp_way(plateau, corner.acceleration_behind, corner.velocity_behind, x - reach_)
                  : ramp_way(plateau, corner.acceleration_before, corner.velocity_before, x - reach_);
  }
  return behind ? plus(plus({}, way, corner.before), way, corner.turn) : plus({}, -way, corner.before);
}

void CornerProbe::execute(Corner const& corner, double plateau, double phase) {
  path_.clear();
  double const first = -2 * reach_;
  double const last = reach_ + delay_;
  static_cast<void>(runtime_->reset(nominal(corner, plateau, first - phase)));
  Point filtered{};
  auto const cycles = static_cast<int>(last - first);
  for (int i = 0; i <= cycles; ++i) {
    double const n = first + i;
    static_cast<void>(runtime_->step(nominal(corner, plateau, n - phase), filtered));
    if (n >= delay_ - reach_) path_.push_back(filtered);
  }
}

double CornerProbe::largest_of_path(Corner const& corner, double plateau, double phase) const {
  double largest = 0;
  double const aside = std::floor(0.7 * reach_);
  double const stride = std::max(1.0, std::floor(aside / points_aside));
  auto const points = static_cast<int>(aside / stride);
  for (int n = -points - 1; n <= points; ++n) {
    // In the middle the corner itself, on either side setpoints.
    double const tau = n == -1 ? 0 : (n < 0 ? n + 1 : n) * stride - phase;
    Point const point = nominal(corner, plateau, tau);
    NearestPoint nearest;
    for (std::size_t i = 1; i < path_.size(); ++i) {
      nearest.consider(point, path_[i - 1], path_[i], runtime_->axis_count());
    }
    for (double const error : nearest.away) largest = std::max(largest, std::abs(error));
  }
  return largest;
}

double CornerProbe::largest_axis_error(Corner const& corner, double plateau, int phases) {
  double largest = 0;
  for (int phase = 0; phase < phases; ++phase) {
    double const share = static_cast<double>(phase) / phases;
    execute(corner, plateau, share);
    largest = std::max(largest, largest_of_path(corner, plateau, share));
  }
  return largest;
}

}  // namespace axisc::motion
