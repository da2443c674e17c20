// Circles as a machine with known errors travels them, by equations of their own.
#pragma once

#include "analysis/circle/recorded_turns.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace axisc::circle {

/// mm, s. The actual position is behind the setpoint by the delay of its axis, with gain, backlash and with a
/// spike after each reversal that decays with `spike_time`; u -= squareness v.
struct SimulatedCircle {
  double cycle = 0.002, radius = 50, feed_mm_per_min = 3000, turns = 2.25;
  std::array<double, 2> centre{100, -30}, delay{}, gain{1, 1}, backlash{}, spike{};
  double spike_time = 0.01, squareness = 0;
  double resolution = 1e-4;  ///< 0: not rounded

  [[nodiscard]] double omega() const { return feed_mm_per_min / 60 / radius; }
  [[nodiscard]] RecordedPath path(Sense sense) const;
};

inline RecordedPath SimulatedCircle::path(Sense sense) const {
  using std::numbers::pi;
  double const s = sign_of(sense);
  auto const rounded = [this](double mm) {
    return (resolution > 0 ? std::round(mm / resolution) * resolution : mm) * 1000;
  };
  auto const past = [](double angle) { return angle - std::floor(angle / pi) * pi; };
  auto const sign = [](double x) { return static_cast<double>((x > 0) - (x < 0)); };
  RecordedPath path;
  path.sample_time = cycle;
  path.resolution = resolution * 1000;
  auto const count = static_cast<int>(turns * 2 * pi / omega() / cycle) + 1;
  for (int n = 0; n < count; ++n) {
    double const t = n * cycle;
    std::array const angle{omega() * (t - delay[0]), omega() * (t - delay[1])};
    std::array position{gain[0] * radius * std::cos(angle[0]), s * gain[1] * radius * std::sin(angle[1])};
    std::array const velocity{-std::sin(angle[0]), s * std::cos(angle[1])};
    std::array const since{past(angle[0]) / omega(), past(angle[1] - pi / 2) / omega()};
    for (std::size_t i = 0; i < 2; ++i) {
      position.at(i) -=
          sign(velocity.at(i)) * (backlash.at(i) / 2 + spike.at(i) * std::exp(-since.at(i) / spike_time));
    }
    position[0] -= squareness * position[1];
    path.setpoint_u.push_back(rounded(centre[0] + radius * std::cos(omega() * t)));
    path.setpoint_v.push_back(rounded(centre[1] + s * radius * std::sin(omega() * t)));
    path.actual_u.push_back(rounded(centre[0] + position[0]));
    path.actual_v.push_back(rounded(centre[1] + position[1]));
  }
  return path;
}

}  // namespace axisc::circle
