#include "analysis/tuning/identification/resonances.hpp"

#include "analysis/motion/statistics.hpp"
#include "analysis/tuning/identification/local_polynomial.hpp"
#include "analysis/tuning/identification/mode_fit.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace axisc::tuning {
namespace {

constexpr double half_power = 0.70710678;
constexpr std::size_t quarters = 4;
constexpr std::size_t fewest_points = 5;
constexpr double smallest_peak = 0.1;  ///< of the largest

struct Candidate {
  std::size_t top = 0;
  std::size_t first = 0, last = 0;  ///< of the half-power band
  double prominence = 0;            ///< height as a multiple of the higher valley
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
    double const low = std::max(valley(i, -1), valley(i, 1));
    if (height[i] < peak_prominence * low) continue;
    Candidate candidate{.top = i, .first = i, .last = i, .prominence = low > 0 ? height[i] / low : 1e300};
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

bool is_excited(MeasuredResponse const& measured, Candidate const& candidate) {
  auto const& excitation = measured.excitation;
  if (excitation.empty()) return true;
  double const strongest = *std::max_element(excitation.begin(), excitation.end());
  return mean_over(excitation, candidate) >= lowest_excitation * strongest;
}

std::optional<Doubt> doubt_about(MeasuredResponse const& measured, Candidate const& candidate) {
  if (!is_excited(measured, candidate)) return Doubt::no_excitation;
  if (!measured.coherence.empty() && mean_over(measured.coherence, candidate) < lowest_coherence) {
    return Doubt::incoherent;
  }
  return std::nullopt;
}

/// Median of |h|/sd between two frequencies, of one entry at least.
double ratio_between(LocalResponse const& local, double lowest, double highest) {
  auto const& frequency = local.response.frequency;
  if (frequency.empty()) return 0;
  auto const place = [&](double f) { return std::lower_bound(frequency.begin(), frequency.end(), f); };
  auto first = place(lowest);
  auto last = place(highest);
  if (first == frequency.end()) --first;
  if (last == frequency.end() || (last > first && *last > highest)) --last;
  std::vector<double> ratios;
  for (auto at = first; at <= last; ++at) {
    auto const i = static_cast<std::size_t>(at - frequency.begin());
    double const size = std::abs(local.response.response[i]);
    double const deviation = local.deviation[i];
    ratios.push_back(size > 0 ? size / std::max(deviation, std::numeric_limits<double>::min()) : 0);
  }
  return motion::median(std::move(ratios));
}

/// The peak also rises above valleys that are higher by their deviation: what lies between two dips of noise
/// is none. Valleys are those of the local polynomials, which are smoother. They round off a sharp peak and
/// count as deviation what they do so, wherever their lines reach it: valleys lie beyond, the height is
/// Welch's, and half of the rise in dB is enough of theirs.
bool rises_for_certain(LocalResponse const& local, MeasuredResponse const& measured,
                       Candidate const& candidate) {
  auto const& frequency = local.response.frequency;
  auto const size = [&](std::ptrdiff_t i) {
    return std::abs(local.response.response[static_cast<std::size_t>(i)]);
  };
  auto const count = static_cast<std::ptrdiff_t>(frequency.size());
  auto const place = [&](std::size_t i) {
    return std::lower_bound(frequency.begin(), frequency.end(), measured.frequency[i]) - frequency.begin();
  };
  auto top = place(candidate.first);
  if (top == count) return false;
  for (auto i = top; i < std::min(count, place(candidate.last) + 1); ++i) {
    if (size(i) > size(top)) top = i;
  }
  double const height = std::max(size(top), std::abs(measured.response[candidate.top]));
  auto const valley = [&](std::ptrdiff_t step) {
    double low = height;
    constexpr auto beyond = static_cast<std::ptrdiff_t>(2 * local_reach + 1);
    for (auto i = top + step * beyond; i >= 0 && i < count && size(i) <= height; i += step) {
      low = std::min(low, size(i) + local.deviation[static_cast<std::size_t>(i)]);
    }
    return low;
  };
  double const low = std::max(valley(-1), valley(1));
  return height >= peak_prominence * low && size(top) >= std::sqrt(peak_prominence) * low;
}

double ratio_of(LocalResponse const& local, MeasuredResponse const& measured, Candidate const& candidate) {
  return ratio_between(local, measured.frequency[candidate.first], measured.frequency[candidate.last]);
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

/// The peak around `peak` that rises most in a quarter; none where the quarter is too uncertain of all.
std::optional<Peak> seen_in(LocalResponse const& quarter, Peak const& peak) {
  constexpr double around = 0.4;
  auto const& measured = quarter.response;
  Candidate const* best = nullptr;
  auto const candidates =
      candidates_of(measured, peak.frequency * (1 - around), peak.frequency * (1 + around));
  for (auto const& candidate : candidates) {
    bool const counts =
        is_excited(measured, candidate) && ratio_of(quarter, measured, candidate) >= lowest_ratio_of_quarter;
    if (counts && (best == nullptr || candidate.prominence > best->prominence)) best = &candidate;
  }
  return best != nullptr ? std::optional(peak_of(measured, *best)) : std::nullopt;
}

/// Compares the quarters; false where the peak moves.
bool stays(Peak& peak, std::vector<LocalResponse> const& parts) {
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
  double const allowed = std::max(largest_movement * peak.frequency, 2 * parts.front().response.resolution());
  if (*most - *least > allowed) return false;
  double const error = motion::standard_error(frequencies);
  // Known worse than it is wide, it would be noise that a narrow mode was fitted to.
  double const width = std::max(peak.damping * peak.frequency, parts.front().response.resolution());
  if (error > width) return false;
  peak.frequency_uncertainty = std::max(peak.frequency_uncertainty / 2, error);
  peak.damping_uncertainty = std::max(peak.damping_uncertainty / 2, motion::standard_error(dampings));
  return true;
}

Identification finished(Identification found) {
  if (found.peaks.empty()) return found;
  std::sort(found.peaks.begin(), found.peaks.end(),
            [](Peak const& a, Peak const& b) { return a.frequency < b.frequency; });
  return {.peaks = std::move(found.peaks), .doubt = std::nullopt};
}

/// Peaks that `doubt` has nothing against; of those that it doubts, the largest one is the reason.
template <class About>
Identification select(MeasuredResponse const& measured, double lowest, double highest, About doubt) {
  Identification found;
  for (auto const& candidate : candidates_of(measured, lowest, highest)) {
    auto peak = peak_of(measured, candidate);
    if (auto const here = doubt(candidate, peak)) {
      if (!found.doubt) {
        found.doubt = here;
        found.doubtful_frequency = measured.frequency[candidate.top];
        found.doubtful_ratio = peak.ratio.value_or(0);
      }
      continue;
    }
    bool const is_large =
        found.peaks.empty() || peak.magnitude >= smallest_peak * found.peaks.front().magnitude;
    if (is_large && found.peaks.size() < most_peaks) found.peaks.push_back(peak);
  }
  if (!found.doubt) found.doubt = doubt_without_peak(measured, lowest, highest);
  return found;
}

}  // namespace

Identification identify(MeasuredResponse const& measured, double lowest, double highest) {
  if (measured.frequency.size() < fewest_points) return {.peaks = {}, .doubt = Doubt::too_short};
  return finished(select(measured, lowest, highest, [&](Candidate const& candidate, Peak const&) {
    return doubt_about(measured, candidate);
  }));
}

Identification identify(std::span<double const> in, std::span<double const> out, double sampling_rate,
                        double lowest, double highest) {
  std::size_t const count = std::min(in.size(), out.size());
  if (count < fewest_samples) return {.peaks = {}, .doubt = Doubt::too_short};
  // Longer recordings have more parts, not finer lines, which would split a wide peak.
  auto const longest =
      std::max(fewest_samples / quarters, static_cast<std::size_t>(longest_part * sampling_rate));
  auto const parts_of = [longest](std::size_t samples) { return (samples + longest - 1) / longest; };
  auto const whole =
      estimate_response(in, out, sampling_rate, std::bit_floor(std::min(count / quarters, longest)));
  auto const local = local_response(in, out, sampling_rate, std::max(quarters, parts_of(count)));
  auto found =
      select(whole, lowest, highest, [&](Candidate const& candidate, Peak& peak) -> std::optional<Doubt> {
        peak.ratio = ratio_of(local, whole, candidate);
        if (!is_excited(whole, candidate)) return Doubt::no_excitation;
        if (*peak.ratio < lowest_ratio) return Doubt::uncertain;
        if (!rises_for_certain(local, whole, candidate)) return Doubt::noisy;
        return std::nullopt;
      });
  std::vector<LocalResponse> parts;
  std::size_t const quarter = count / quarters;
  for (std::size_t i = 0; i < quarters; ++i) {
    parts.push_back(local_response(in.subspan(i * quarter, quarter), out.subspan(i * quarter, quarter),
                                   sampling_rate, parts_of(quarter)));
  }
  std::vector<Peak> peaks;
  for (auto peak : found.peaks) {
    if (stays(peak, parts)) {
      peaks.push_back(peak);
    } else if (peaks.empty()) {
      found.doubt = Doubt::moving;
      found.doubtful_frequency = peak.frequency;
    }
  }
  found.peaks = std::move(peaks);
  return finished(std::move(found));
}

}  // namespace axisc::tuning
