#include "analysis/tuning/suggestion/excitation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axisc::tuning {
namespace {

std::vector<motion::Phase> phases_of(Task const& task) {
  double const duration = task.velocity / task.acceleration;
  std::vector<motion::Phase> phases;
  if (task.ramp) {
    task.ramp->append_up(0, task.velocity, phases);
  } else {
    phases.push_back(
        {.duration = duration, .length = task.velocity * duration / 2, .acceleration = task.acceleration});
  }
  phases.push_back(motion::Phase::steady(task.velocity, 2 * task.velocity));
  return phases;
}

std::vector<double> ramp_of(Task const& task) {
  auto const phases = phases_of(task);
  std::size_t at = 0;
  double begun = 0;
  double passed = 0;
  auto const way_at = [&](double t) {
    while (at + 1 < phases.size() && t >= begun + phases[at].duration) {
      begun += phases[at].duration;
      passed += phases[at++].length;
    }
    return passed + phases[at].way_at(t - begun);
  };
  double duration = 0;
  for (std::size_t i = 0; i + 1 < phases.size(); ++i) duration += phases[i].duration;
  auto const last = static_cast<int>(std::ceil(duration));
  std::vector<double> ramp;
  double velocity = 0;
  double way = 0;
  for (int n = 0; n < last; ++n) {
    double const next = way_at(n + 1);
    ramp.push_back(next - way - velocity);
    velocity = next - way;
    way = next;
  }
  if (task.velocity - velocity > 1e-9 * task.velocity) ramp.push_back(task.velocity - velocity);
  return ramp;
}

}  // namespace

Excitation::Excitation(Task const& task) : ramp_(ramp_of(task)) {
  double const per_cycle = 2 * std::numbers::pi * task.cycle_time.seconds();
  auto const unfiltered = drive_behind({});
  for (auto const& resonance : task.resonances) {
    double const change =
        std::min(std::max(frequency_tolerance * resonance.frequency, 2 * resonance.uncertainty),
                 resonance.frequency / 2);
    Swinging one{.band = {.lowest = per_cycle * (resonance.frequency - change),
                          .highest = per_cycle * (resonance.frequency + change),
                          .least_damping = lowest_damping,
                          .most_damping = highest_damping},
                 .frequency = per_cycle * resonance.frequency,
                 .damping = resonance.damping.value_or(lowest_damping)};
    one.unfiltered_worst = largest_swing(unfiltered, one.band, 0);
    one.unfiltered_own = swing(unfiltered, one.frequency, one.damping);
    resonances_.push_back(one);
  }
}

Drive Excitation::drive_behind(ImpulseResponse const& chain) const {
  return {
      .jumps = in_series({.taps = ramp_, .delay = 0}, chain).taps,
      .rest = ramp_.size() - 1 + static_cast<std::size_t>(std::max(0.0, std::ceil(2 * chain.delay - 1e-6)))};
}

std::vector<Vibration> Excitation::after(ImpulseResponse const& chain) const {
  auto const drive = drive_behind(chain);
  std::vector<Vibration> found;
  for (auto const& one : resonances_) {
    double const worst = largest_swing(drive, one.band, negligible_vibration * one.unfiltered_worst);
    found.push_back({.worst = worst / one.unfiltered_worst,
                     .amplitude = swing(drive, one.frequency, one.damping),
                     .unfiltered = one.unfiltered_own});
  }
  return found;
}

double Excitation::at_least_after(ImpulseResponse const& chain) const {
  auto const drive = drive_behind(chain);
  double worst = 0;
  for (auto const& one : resonances_) {
    worst = std::max(worst, swing_at_least(drive, one.band) / one.unfiltered_worst);
  }
  return worst;
}

}  // namespace axisc::tuning
