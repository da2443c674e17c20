#include "analysis/tuning/identification/resonances.hpp"

#include "analysis/tuning/identification/mode_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace axisc::tuning {
namespace {

constexpr double half_power = 0.70710678;
constexpr std::size_t quarters = 4;
constexpr std::size_t fewest_points = 5;
constexpr double smallest_peak = 0.1;  ///< of the largest
/// For a quarter, whose resolution is so coarse that a sharp peak loses coherence.
constexpr double lowest_coherence_of_part = 0.5;

struct Candidate {
  std::size_t top = 0;
  std::size_t first = 0, last = 0;  ///< of the half-power band
};

/// Places that rise by peak_prominence above the lowest point on either side before something higher comes.
std::vector<Candidate> candidates_of(MeasuredResponse const& measured, double lowest, double highest) {
  auto const& frequency = measured.frequency;
  std::vector<double> height;
  for (auto const& value : measured.response) height.push_back(std::abs(value));
  auto const valley = [&](std::size_t top, int step) {
    double low = height[top];
    auto const end = step < 0 ? std::ptrdiff_t{-1} : static_cast<std::ptrdiff_t>(height.size());
    for (auto i = static_cast<std::ptrdiff_t>(top) + step; i != end; i += step) {
      double const here = height[static_cast<std::size_t>(i)];
      if (here > height[top]) break;
      low = std::min(low, here);
    }
    return low;
  };
  std::vector<Candidate> found;
  for (std::size_t i = 1; i + 1 < height.size(); ++i) {
    if (frequency[i] < lowest || frequency[i] > highest) continue;
    if (height[i] < height[i - 1] || height[i] <= height[i + 1]) continue;
    if (height[i] < peak_prominence * std::max(valley(i, -1), valley(i, 1))) continue;
    Candidate candidate{.top = i, .first = i, .last = i};
    while (candidate.first > 0 && height[candidate.first - 1] >= half_power * height[i]) --candidate.first;
    while (candidate.last + 1 < height.size() && height[candidate.last + 1] >= half_power * height[i]) {
      ++candidate.last;
    }
    found.push_back(candidate);
  }
  std::stable_sort(found.begin(), found.end(),
                   [&](Candidate const& a, Candidate const& b) { return height[a.top] > height[b.top]; });
  return found;
}

double mean_over(std::vector<double> const& values, Candidate const& candidate) {
  auto const first = values.begin() + static_cast<std::ptrdiff_t>(candidate.first);
  auto const last = values.begin() + static_cast<std::ptrdiff_t>(candidate.last) + 1;
  return std::accumulate(first, last, 0.0) / static_cast<double>(last - first);
}

std::optional<Doubt> doubt_about(MeasuredResponse const& measured, Candidate const& candidate,
                                 double least_coherence = lowest_coherence) {
  auto const& excitation = measured.excitation;
  if (!excitation.empty()) {
    double const strongest = *std::max_element(excitation.begin(), excitation.end());
    if (mean_over(excitation, candidate) < lowest_excitation * strongest) return Doubt::no_excitation;
  }
  if (!measured.coherence.empty() && mean_over(measured.coherence, candidate) < least_coherence) {
    return Doubt::incoherent;
  }
  return std::nullopt;
}

/// If no peak rises because most of the band was not excited, the reason is missing excitation.
Doubt doubt_without_peak(MeasuredResponse const& measured, double lowest, double highest) {
  std::size_t in_band = 0;
  std::size_t coherent = 0;
  for (std::size_t i = 0; i < measured.coherence.size(); ++i) {
    if (measured.frequency[i] < lowest || measured.frequency[i] > highest) continue;
    ++in_band;
    coherent += measured.coherence[i] >= lowest_coherence ? 1 : 0;
  }
  return 2 * coherent < in_band ? Doubt::no_excitation : Doubt::no_peak;
}

Peak peak_of(MeasuredResponse const& measured, Candidate const& candidate) {
  auto const mode = fit_mode(measured, candidate.top);
  Peak peak{.frequency = mode.frequency,
            .frequency_uncertainty = measured.resolution() / 2,
            .damping = mode.damping,
            .damping_uncertainty = measured.resolution() / 2 / mode.frequency,
            .magnitude = std::abs(measured.response[candidate.top])};
  if (!measured.coherence.empty()) peak.coherence = mean_over(measured.coherence, candidate);
  return peak;
}

std::size_t power_of_two_within(std::size_t count) {
  std::size_t power = 1;
  while (2 * power <= count) power *= 2;
  return power;
}

/// The peak next to `peak` in a part of the recording; none where that part does not show it.
std::optional<Peak> seen_in(MeasuredResponse const& part, Peak const& peak) {
  constexpr double around = 0.4;
  auto const candidates = candidates_of(part, peak.frequency * (1 - around), peak.frequency * (1 + around));
  for (auto const& candidate : candidates) {
    if (!doubt_about(part, candidate, lowest_coherence_of_part)) return peak_of(part, candidate);
  }
  return std::nullopt;
}

/// Compares the quarters; false where the peak moves.
bool stays(Peak& peak, std::vector<MeasuredResponse> const& parts) {
  std::vector<double> frequencies, dampings;
  for (auto const& part : parts) {
    if (auto const seen = seen_in(part, peak)) {
      frequencies.push_back(seen->frequency);
      dampings.push_back(seen->damping);
    }
  }
  // Most quarters must show it.
  if (2 * frequencies.size() <= quarters) return false;
  auto const [least, most] = std::minmax_element(frequencies.begin(), frequencies.end());
  double const allowed = std::max(largest_movement * peak.frequency, 2 * parts.front().resolution());
  if (*most - *least > allowed) return false;
  auto const error = [](std::vector<double> const& values) {
    auto const count = static_cast<double>(values.size());
    double const mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    double sum = 0;
    for (double const value : values) sum += (value - mean) * (value - mean);
    return std::sqrt(sum / (count - 1) / count);
  };
  peak.frequency_uncertainty = std::max(peak.frequency_uncertainty / 2, error(frequencies));
  peak.damping_uncertainty = std::max(peak.damping_uncertainty / 2, error(dampings));
  return true;
}

Identification finished(std::vector<Peak> peaks, std::optional<Doubt> doubt, double doubtful) {
  if (peaks.empty()) return {.peaks = {}, .doubt = doubt, .doubtful_frequency = doubtful};
  std::sort(peaks.begin(), peaks.end(),
            [](Peak const& a, Peak const& b) { return a.frequency < b.frequency; });
  return {.peaks = std::move(peaks), .doubt = std::nullopt, .doubtful_frequency = 0};
}

}  // namespace

Identification identify(MeasuredResponse const& measured, double lowest, double highest) {
  if (measured.frequency.size() < fewest_points) return finished({}, Doubt::too_short, 0);
  std::vector<Peak> peaks;
  std::optional<Doubt> doubt;
  double doubtful = 0;
  for (auto const& candidate : candidates_of(measured, lowest, highest)) {
    if (auto const here = doubt_about(measured, candidate)) {
      if (!doubt) {
        doubt = here;
        doubtful = measured.frequency[candidate.top];
      }
      continue;
    }
    auto const peak = peak_of(measured, candidate);
    bool const is_large = peaks.empty() || peak.magnitude >= smallest_peak * peaks.front().magnitude;
    if (is_large && peaks.size() < most_peaks) peaks.push_back(peak);
  }
  if (!doubt) doubt = doubt_without_peak(measured, lowest, highest);
  return finished(std::move(peaks), doubt, doubtful);
}

Identification identify(std::span<double const> in, std::span<double const> out, double sampling_rate,
                        double lowest, double highest) {
  std::size_t const count = std::min(in.size(), out.size());
  if (count < fewest_samples) return finished({}, Doubt::too_short, 0);
  auto const whole =
      identify(estimate_response(in, out, sampling_rate, power_of_two_within(count / 4)), lowest, highest);
  std::vector<MeasuredResponse> parts;
  std::size_t const quarter = count / quarters;
  for (std::size_t i = 0; i < quarters; ++i) {
    parts.push_back(estimate_response(in.subspan(i * quarter, quarter), out.subspan(i * quarter, quarter),
                                      sampling_rate, power_of_two_within(quarter / 4)));
  }
  std::vector<Peak> peaks;
  auto doubt = whole.doubt;
  double doubtful = whole.doubtful_frequency;
  for (auto peak : whole.peaks) {
    if (stays(peak, parts)) {
      peaks.push_back(peak);
    } else if (!doubt) {
      doubt = Doubt::moving;
      doubtful = peak.frequency;
    }
  }
  return finished(std::move(peaks), doubt, doubtful);
}

}  // namespace axisc::tuning
