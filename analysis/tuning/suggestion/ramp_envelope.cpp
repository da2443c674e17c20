#include "analysis/tuning/suggestion/ramp_envelope.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace axisc::tuning {

double trapez_envelope(double x) {
  return x == 0 ? 1 : std::abs(std::sin(x) / x);
}

double sine_envelope(double x) {
  double const part = 1 - std::pow(2 * x / std::numbers::pi, 2);
  // cos x / (1 - (2x/π)²) → π/4 for x → π/2
  constexpr double near_zero = 1e-9;
  if (std::abs(part) < near_zero) return std::numbers::pi / 4;
  return std::abs(std::cos(x) / part);
}

double envelope(motion::Ramp const& ramp, double velocity, double frequency) {
  if (ramp.is_step()) return 1;
  std::vector<motion::Phase> phases;
  ramp.append_up(0, velocity, phases);
  double sum = 0;
  for (auto const& phase : phases) {
    // x = π f tr
    double const x = frequency * phase.duration / 2;
    bool const is_sine = phase.shape != motion::PhaseShape::constant_jerk;
    double const peak = is_sine ? phase.acceleration : std::abs(phase.jerk) * phase.duration;
    sum += peak * (is_sine ? sine_envelope(x) : trapez_envelope(x));
  }
  return sum / (2 * ramp.times().acceleration);
}

}  // namespace axisc::tuning
