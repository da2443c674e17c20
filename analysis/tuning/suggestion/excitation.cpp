#include "analysis/tuning/suggestion/excitation.hpp"

#include "analysis/motion/axis_ramps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace axisc::tuning {
namespace {

/// a[n] of a ramp that begins on a cycle at the velocity `from`, and ends at `to`.
std::vector<double> jumps_of(std::vector<motion::Phase> phases, double from, double to) {
  double duration = 0;
  for (auto const& phase : phases) duration += phase.duration;
  // One cycle more than is looked at.
  if (to > 0) phases.push_back(motion::Phase::steady(to, 2 * to));
  std::size_t at = 0;
  double begun = 0;
  double passed = 0;
  auto const way_at = [&](double t) {
    while (at + 1 < phases.size() && t >= begun + phases[at].duration) {
      begun += phases[at].duration;
      passed += phases[at++].length;
    }
    return passed + phases[at].way_at(std::min(t - begun, phases[at].duration));
  };
  auto const last = static_cast<int>(std::ceil(duration));
  std::vector<double> jumps;
  double velocity = from;
  double way = 0;
  for (int n = 0; n < last; ++n) {
    double const next = way_at(n + 1);
    jumps.push_back(next - way - velocity);
    velocity = next - way;
    way = next;
  }
  constexpr double rounding = 1e-9;
  if (std::abs(to - velocity) > rounding * std::max(from, to)) jumps.push_back(to - velocity);
  return jumps;
}

/// Braking is accelerating backwards where both have the same accelerations and times.
bool is_opposite(std::vector<double> const& up, std::vector<double> const& down, double velocity) {
  constexpr double rounding = 1e-9;
  return std::equal(up.begin(), up.end(), down.begin(), down.end(),
                    [velocity](double a, double b) { return std::abs(a + b) <= rounding * velocity; });
}

/// Rest to velocity, and velocity to rest where that is another motion.
std::vector<std::vector<double>> ramps_of(Task const& task) {
  auto const [up, down] = motion::axis_ramps(task.dynamics);
  std::vector<motion::Phase> rising;
  std::vector<motion::Phase> falling;
  up.append_up(0, task.velocity, rising);
  down.append_down(task.velocity, 0, falling);
  std::vector<std::vector<double>> ramps = {jumps_of(std::move(rising), 0, task.velocity)};
  auto braking = jumps_of(std::move(falling), task.velocity, 0);
  if (!is_opposite(ramps.front(), braking, task.velocity)) ramps.push_back(std::move(braking));
  return ramps;
}

/// Σ a[k] p^(N - 1 - k)
std::complex<double> rung(std::vector<double> const& a, std::complex<double> p) {
  std::complex<double> q = 0;
  for (double const value : a) q = q * p + value;
  return q;
}

/// The largest of what each drive gives.
template <class Swing>
double largest(std::vector<Drive> const& drives, Swing swing_of) {
  double most = 0;
  for (auto const& drive : drives) most = std::max(most, swing_of(drive));
  return most;
}

}  // namespace

Excitation::Excitation(Task const& task) : ramps_(ramps_of(task)) {
  double const per_cycle = 2 * std::numbers::pi * task.cycle_time.seconds();
  auto const unfiltered = drives_behind({});
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
    one.unfiltered_worst =
        largest(unfiltered, [&](Drive const& drive) { return largest_swing(drive, one.band, 0); });
    one.unfiltered_own =
        largest(unfiltered, [&](Drive const& drive) { return swing(drive, one.frequency, one.damping); });
    resonances_.push_back(one);
    add_places(one);
  }
}

void Excitation::add_places(Swinging const& one) {
  double const damping = one.band.least_damping;
  for (int i = 0; i < places_of_band; ++i) {
    double const along = static_cast<double>(i) / (places_of_band - 1);
    double const frequency = one.band.lowest + along * (one.band.highest - one.band.lowest);
    double const damped = frequency * std::sqrt(1 - damping * damping);
    Place place{.p = std::exp(std::complex<double>(-frequency * damping, damped)),
                .share = 1 / (damped * one.unfiltered_worst),
                .ramps = {}};
    for (auto const& ramp : ramps_) place.ramps.push_back(rung(ramp, place.p));
    places_.push_back(std::move(place));
  }
}

std::vector<std::complex<double>> Excitation::ringing(ImpulseResponse const& chain) const {
  std::vector<std::complex<double>> found;
  found.reserve(places_.size());
  for (auto const& place : places_) found.push_back(rung(chain.taps, place.p));
  return found;
}

double Excitation::at_least_ringing(std::vector<std::complex<double>> const& ringing, std::size_t taps,
                                    double delay) const {
  double const late = std::ceil(2 * delay - 1e-6);
  double const waits = std::max(0.0, late - static_cast<double>(taps - 1));
  double most = 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    auto const& place = places_[i];
    double const decay = waits == 0 ? 1 : std::pow(std::abs(place.p), waits);
    for (auto const& ramp : place.ramps) {
      most = std::max(most, std::abs(ramp * ringing[i]) * decay * place.share);
    }
  }
  return most;
}

std::vector<Drive> Excitation::drives_behind(ImpulseResponse const& chain) const {
  auto const late = static_cast<std::size_t>(std::max(0.0, std::ceil(2 * chain.delay - 1e-6)));
  std::vector<Drive> drives;
  for (auto const& ramp : ramps_) {
    drives.push_back(
        {.jumps = in_series({.taps = ramp, .delay = 0}, chain).taps, .rest = ramp.size() - 1 + late});
  }
  return drives;
}

std::vector<Vibration> Excitation::after(ImpulseResponse const& chain) const {
  auto const drives = drives_behind(chain);
  std::vector<Vibration> found;
  for (auto const& one : resonances_) {
    double const negligible = negligible_vibration * one.unfiltered_worst;
    double const worst =
        largest(drives, [&](Drive const& drive) { return largest_swing(drive, one.band, negligible); });
    double const own =
        largest(drives, [&](Drive const& drive) { return swing(drive, one.frequency, one.damping); });
    found.push_back(
        {.worst = worst / one.unfiltered_worst, .amplitude = own, .unfiltered = one.unfiltered_own});
  }
  return found;
}

double Excitation::at_least_after(ImpulseResponse const& chain) const {
  auto const drives = drives_behind(chain);
  double worst = 0;
  for (auto const& one : resonances_) {
    double const here = largest(drives, [&](Drive const& drive) { return swing_at_least(drive, one.band); });
    worst = std::max(worst, here / one.unfiltered_worst);
  }
  return worst;
}

std::vector<Vibration> Excitation::beside(Excitation const& present) const {
  std::vector<Vibration> found;
  for (std::size_t i = 0; i < resonances_.size(); ++i) {
    auto const& before = present.resonances_[i];
    found.push_back({.worst = resonances_[i].unfiltered_worst / before.unfiltered_worst,
                     .amplitude = resonances_[i].unfiltered_own,
                     .unfiltered = before.unfiltered_own});
  }
  return found;
}

}  // namespace axisc::tuning
