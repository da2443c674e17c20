#include "tuning/suggestion/excitation.hpp"

#include "motion/velocity_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace axisc::tuning {
namespace {

/// As shares of the tolerated change of frequency.
constexpr std::array frequency_steps = {-1.0, -0.5, 0.0, 0.5, 1.0};
/// The lowest, the highest and their geometric mean.
constexpr std::array dampings = {lowest_damping, 0.0632455532, highest_damping};
constexpr std::size_t grid = frequency_steps.size() * dampings.size();

std::vector<double> ramp_of(Task const& task) {
  double const duration = task.velocity / task.acceleration;
  motion::VelocityProfile const profile({.length = task.velocity * (duration + 2),
                                         .velocity_in = 0,
                                         .velocity_out = task.velocity,
                                         .velocity_limit = task.velocity,
                                         .acceleration = task.acceleration});
  auto const last = static_cast<int>(std::ceil(duration));
  std::vector<double> ramp;
  double velocity = 0;
  for (int n = 0; n < last; ++n) {
    double const next = profile.way_at(n + 1) - profile.way_at(n);
    ramp.push_back(next - velocity);
    velocity = next;
  }
  if (task.velocity - velocity > 1e-9 * task.velocity) ramp.push_back(task.velocity - velocity);
  return ramp;
}

}  // namespace

Excitation::Excitation(Task const& task) : ramp_(ramp_of(task)) {
  double const T = task.cycle_time.seconds();
  auto const add = [&](double frequency, double damping) {
    double const omega = 2 * std::numbers::pi * frequency;
    double const damped = omega * std::sqrt(1 - damping * damping);
    double const radius = std::exp(-damping * omega * T);
    cosine_.push_back(radius * std::cos(damped * T));
    sine_.push_back(radius * std::sin(damped * T));
    scale_.push_back(1 / (damped * T));
  };
  for (auto const& resonance : task.resonances) {
    double const change =
        std::min(std::max(frequency_tolerance * resonance.frequency, 2 * resonance.uncertainty),
                 resonance.frequency / 2);
    for (double const step : frequency_steps) {
      for (double const damping : dampings) add(resonance.frequency + step * change, damping);
    }
    add(resonance.frequency, resonance.damping.value_or(lowest_damping));
  }
  unfiltered_ = amplitudes({});
}

std::vector<double> Excitation::amplitudes(ImpulseResponse const& chain) const {
  auto const driven = in_series({.taps = ramp_, .delay = 0}, chain).taps;
  auto const rest = ramp_.size() - 1 + static_cast<std::size_t>(std::ceil(2 * chain.delay - 1e-6));
  std::size_t const poles = cosine_.size();
  std::vector<double> re(poles), im(poles), largest(poles);
  std::size_t const end = std::max(driven.size(), rest + 1);
  double* const x = re.data();
  double* const y = im.data();
  double* const top = largest.data();
  double const* const c = cosine_.data();
  double const* const s = sine_.data();
  for (std::size_t n = 0; n < end; ++n) {
    double const jump = n < driven.size() ? driven[n] : 0;
    for (std::size_t i = 0; i < poles; ++i) {
      double const next = x[i] * c[i] - y[i] * s[i] + jump;
      y[i] = x[i] * s[i] + y[i] * c[i];
      x[i] = next;
    }
    if (n < rest) continue;
    for (std::size_t i = 0; i < poles; ++i) {
      double const power = x[i] * x[i] + y[i] * y[i];
      top[i] = power > top[i] ? power : top[i];
    }
  }
  for (std::size_t i = 0; i < poles; ++i) largest[i] = std::sqrt(largest[i]) * scale_[i];
  return largest;
}

std::vector<Vibration> Excitation::after(ImpulseResponse const& chain) const {
  auto const filtered = amplitudes(chain);
  std::vector<Vibration> found;
  for (std::size_t begin = 0; begin < filtered.size(); begin += grid + 1) {
    auto const worst_of = [&](std::vector<double> const& amplitudes) {
      auto const first = amplitudes.begin() + static_cast<std::ptrdiff_t>(begin);
      return *std::max_element(first, first + static_cast<std::ptrdiff_t>(grid));
    };
    found.push_back({.worst = worst_of(filtered) / worst_of(unfiltered_),
                     .amplitude = filtered[begin + grid],
                     .unfiltered = unfiltered_[begin + grid]});
  }
  return found;
}

}  // namespace axisc::tuning
