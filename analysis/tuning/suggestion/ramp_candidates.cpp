#include "analysis/tuning/suggestion/ramp_candidates.hpp"

#include "analysis/motion/axis_ramps.hpp"
#include "analysis/tuning/suggestion/choice.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::tuning {
namespace {

Task with_ramp_time(Task task, double microseconds) {
  auto& feed = task.dynamics.axes.front().feed;
  for (auto* const ramp : {&feed.up, &feed.down}) ramp->build_up = ramp->take_back = microseconds;
  return task;
}

/// The ramp time of a zero, rounded up to what a list can say.
std::uint32_t time_of_zero(Task const& task, std::size_t resonance, int zero) {
  constexpr double us_per_s = 1e6;
  bool const is_sine = task.dynamics.channel.slope == machine::Slope::sin2;
  double const periods = is_sine ? zero + 0.5 : zero;
  return static_cast<std::uint32_t>(std::ceil(periods / task.resonances[resonance].frequency * us_per_s));
}

RampCandidate judged(Task const& task, Excitation const& present, RampCandidate candidate) {
  auto const changed = with_ramp_time(task, candidate.ramp_time);
  candidate.resonances = Excitation(changed).beside(present);
  candidate.vibration = 0;
  for (auto const& one : candidate.resonances) {
    candidate.vibration = std::max(candidate.vibration, one.worst);
  }
  auto const [up, down] = motion::axis_ramps(changed.dynamics);
  candidate.up_time = up.duration(0, task.velocity);
  candidate.down_time = down.duration(0, task.velocity);
  return candidate;
}

}  // namespace

std::optional<RampCandidates> ramp_candidates(Task const& task, Excitation const& present) {
  if (task.dynamics.channel.slope == machine::Slope::step) return std::nullopt;
  auto const [up, down] = motion::axis_ramps(task.dynamics);
  RampCandidates found{.up_time = up.duration(0, task.velocity),
                       .down_time = down.duration(0, task.velocity)};
  auto& candidates = found.candidates;
  for (std::size_t i = 0; i < task.resonances.size(); ++i) {
    for (int zero = 1; zero <= most_zeros; ++zero) {
      auto const time = time_of_zero(task, i, zero);
      bool const is_known = std::any_of(candidates.begin(), candidates.end(),
                                        [time](RampCandidate const& one) { return one.ramp_time == time; });
      if (is_known || time < task.dynamics.axes.front().shortest_ramp_time) continue;
      candidates.push_back(judged(task, present, {.ramp_time = time, .resonance = i, .zero = zero}));
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](RampCandidate const& one, RampCandidate const& other) {
    return one.ramp_time < other.ramp_time;
  });
  auto const quickest = std::find_if(candidates.begin(), candidates.end(), [](RampCandidate const& one) {
    return one.vibration <= sufficient_vibration;
  });
  if (quickest != candidates.end()) {
    found.quickest = static_cast<std::size_t>(quickest - candidates.begin());
  }
  return found;
}

}  // namespace axisc::tuning
