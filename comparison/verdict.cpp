#include "comparison/verdict.hpp"

#include "comparison/liveliness.hpp"
#include "comparison/residual.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::comparison {

namespace {

constexpr std::size_t fewest_cycles = 50;
/// Cycles of which readings are tried; the listed chain is run over all of them.
constexpr std::size_t longest_trial = 16384;
/// What fits has at most this much more than the resolution explains, and at most this many steps of it anywhere.
constexpr double rms_margin = 1.4;
constexpr double steps_margin = 3;
/// A reading that is this much worse than the best one does not fit.
constexpr double clearly_worse = 1.1;
/// Of the listed chain and a reading that both fit, the reading is believed where its error is so much smaller.
constexpr double believed_gain = 1.25;
constexpr double numeric_noise = 2e-9;

double largest_magnitude(Signal const& signal) {
  double largest = 0;
  for_each_part(signal, [&](std::size_t, std::span<double const> values) {
    for (double const value : values) largest = std::max(largest, std::abs(value));
  });
  return largest;
}

/// The liveliest part of a long recording, which the readings are tried on.
Recording busiest_part(Recording const& whole, std::size_t settling) {
  std::size_t const length = longest_trial + settling;
  if (whole.input.size() <= length) return whole;
  std::size_t const best = liveliest_part(whole.input, length);
  auto const part = [&](Signal const& signal) {
    std::vector<double> values(length);
    signal.read(best, values);
    return Signal(values);
  };
  Recording taken{
      .input = part(whole.input), .output = part(whole.output), .gaps = {}, .first = whole.first + best};
  for (auto const gap : whole.gaps) {
    if (gap >= best && gap < best + length) taken.gaps.push_back(gap - best);
  }
  return taken;
}

/// What rounding of the two columns explains.
struct Allowance {
  double input = 0, output = 0;  ///< their resolutions
  double noise = 0;
  [[nodiscard]] double rms(double gain = 1) const {
    return std::hypot(gain * input, output) / std::sqrt(12.0);
  }
  /// What a recording can measure: less is luck, as of a slow motion, where rounding of both columns is alike.
  [[nodiscard]] double measurable(Residual const& residual) const {
    return std::max(residual.rms, output / std::sqrt(12.0));
  }
  [[nodiscard]] bool holds(Residual const& residual, double gain = 1) const {
    return residual.rms <= rms_margin * rms(gain) + noise &&
           residual.largest <= steps_margin * std::max(gain * input, output) + 10 * noise;
  }
  /// A chain that enhances high frequencies enhances what was rounded off its input.
  [[nodiscard]] bool holds(Explained const& explained) const {
    constexpr double largest_gain = 10;
    if (holds(explained.residual)) return true;
    if (!holds(explained.residual, largest_gain)) return false;
    return holds(explained.residual, std::clamp(noise_gain(explained.reading.chain), 1.0, largest_gain));
  }
};

bool has_fewer_departures(Explained const& one, Explained const& other) {
  return one.reading.departures.size() < other.reading.departures.size();
}

bool is_same_reading(Reading const& one, Reading const& other) {
  return std::equal(one.departures.begin(), one.departures.end(), other.departures.begin(),
                    other.departures.end(),
                    [](Departure const& a, Departure const& b) { return a.id == b.id; });
}

/// Departs in all that the other one departs in.
bool goes_further(Explained const& one, Explained const& other) {
  auto const& more = one.reading.departures;
  auto const& fewer = other.reading.departures;
  return std::all_of(fewer.begin(), fewer.end(), [&](Departure const& departure) {
    return std::any_of(more.begin(), more.end(),
                       [&](Departure const& its) { return its.id == departure.id; });
  });
}

std::vector<Explained> tried(Recording const& part, std::vector<Reading> const& all,
                             double output_resolution) {
  std::vector<Explained> found;
  std::size_t settling = 0;
  for (auto const& reading : all) settling = std::max(settling, settling_cycles(reading.chain));
  auto const counted = counted_cycles(part, {.settling = settling, .output_resolution = output_resolution});
  auto const input = part.input.values();
  auto const output = part.output.values();
  for (auto const& reading : all) {
    if (reading.departures.empty()) {
      found.push_back({reading, residual_of(reading.chain, part, counted)});
    } else {
      found.push_back({reading, residual_of(respond(reading.chain, input, part.first), output, counted)});
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](Explained const& a, Explained const& b) { return a.residual.rms < b.residual.rms; });
  return found;
}

/// Of the readings that fit, those with fewest departures and those that only add to the best of these, unless one with more is
/// better than they are; then all of those that are about as good. What does not belong to them is next. `found` by rising rms.
void explain(Comparison& comparison, std::vector<Explained> const& found, Allowance const& allowance) {
  std::vector<Explained> plausible;
  for (auto const& one : found) {
    if (one.reading.departures.empty() || !allowance.holds(one)) continue;
    double const best = allowance.measurable(plausible.empty() ? one.residual : plausible.front().residual);
    if (one.residual.rms <= believed_gain * best + allowance.noise) plausible.push_back(one);
  }
  if (!plausible.empty()) {
    double const best = allowance.measurable(plausible.front().residual);
    auto const simplest = *std::min_element(plausible.begin(), plausible.end(), has_fewer_departures);
    auto const limit = clearly_worse * allowance.measurable(simplest.residual) + allowance.noise;
    if (simplest.residual.rms <= clearly_worse * best + allowance.noise) {
      std::erase_if(plausible, [&](Explained const& one) {
        bool const is_far_fetched = has_fewer_departures(simplest, one) && !goes_further(one, simplest);
        return is_far_fetched || one.residual.rms > limit;
      });
    }
  }
  comparison.fitting = plausible;
  for (auto const& one : found) {
    bool const is_named = std::any_of(plausible.begin(), plausible.end(), [&](Explained const& named) {
      return is_same_reading(named.reading, one.reading);
    });
    if (one.reading.departures.empty() || is_named) continue;
    comparison.next = one;
    break;
  }
}

}  // namespace

Comparison compare(Recording const& recording, std::vector<Reading> const& all) {
  Comparison comparison;
  comparison.lost = recording.gaps.size();
  comparison.input_resolution = resolution(recording.input, recording.gaps);
  comparison.output_resolution = resolution(recording.output, recording.gaps);
  Allowance const allowance{.input = comparison.input_resolution,
                            .output = comparison.output_resolution,
                            .noise = numeric_noise * std::max(largest_magnitude(recording.output), 1e-3)};
  comparison.allowed_rms = allowance.rms();

  auto const settling = settling_cycles(all.front().chain);
  auto const mask =
      counted_cycles(recording, {.settling = settling, .output_resolution = comparison.output_resolution});
  comparison.compared = static_cast<std::size_t>(std::count(mask.begin(), mask.end(), true));
  if (comparison.compared < fewest_cycles) return comparison;
  comparison.listed = residual_of(all.front().chain, recording, mask);
  bool const is_same = allowance.holds(Explained{all.front(), comparison.listed});
  if (is_same) {
    comparison.verdict = comparison.listed.delay_cycles == 0 ? Verdict::same : Verdict::delayed;
  } else {
    comparison.verdict = Verdict::different;
  }
  std::size_t longest = 0;
  for (auto const& reading : all) longest = std::max(longest, settling_cycles(reading.chain));
  explain(comparison, tried(busiest_part(recording, longest), all, comparison.output_resolution), allowance);
  if (!is_same) return comparison;
  if (!comparison.fitting.empty() &&
      allowance.measurable(comparison.fitting.front().residual) * believed_gain < comparison.listed.rms) {
    comparison.verdict = Verdict::different;
    return comparison;
  }
  std::erase_if(comparison.fitting, [&](Explained const& one) {
    return one.residual.rms > clearly_worse * allowance.measurable(comparison.listed) + allowance.noise;
  });
  return comparison;
}

std::optional<design::Readings> settings_of(Comparison const& comparison, design::Readings const& current) {
  if (comparison.verdict == Verdict::same || comparison.verdict == Verdict::delayed) return current;
  if (comparison.verdict != Verdict::different || comparison.fitting.size() != 1) return std::nullopt;
  design::Readings settings = current;
  for (auto const& departure : comparison.fitting.front().reading.departures) {
    using namespace design;
    if (auto const filters = reading_of<FilterReading>(filter_reading_words, departure.id)) {
      settings.filters = *filters;
    } else if (auto const kernels = reading_of<KernelReading>(kernel_reading_words, departure.id)) {
      settings.kernels = *kernels;
    } else if (departure.id == documented_filters) {
      settings.filters = FilterReading::documented;
    } else if (departure.id == documented_kernels) {
      settings.kernels = KernelReading::documented;
    } else if (departure.id == documented_cycle_time) {
      settings.cycle_time = CycleReading::documented;
    } else if (departure.id == cycle_time_double) {
      settings.cycle_time = CycleReading::twice;
    } else if (departure.id == cycle_time_half) {
      settings.cycle_time = CycleReading::half;
    } else if (departure.id == cycle_time_fourfold) {
      settings.cycle_time = CycleReading::fourfold;
    } else if (departure.id == cycle_time_quarter) {
      settings.cycle_time = CycleReading::quarter;
    } else {
      return std::nullopt;
    }
  }
  return settings;
}

}  // namespace axisc::comparison
