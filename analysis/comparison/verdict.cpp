#include "analysis/comparison/verdict.hpp"

#include "analysis/comparison/liveliness.hpp"
#include "analysis/comparison/residual.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::comparison {

namespace {

constexpr std::size_t fewest_cycles = 50;
/// Cycles on which readings are tried; the listed chain is run over the whole recording.
constexpr std::size_t longest_trial = 16384;
/// A reading fits if its rms is at most this many times what the resolution explains, and no error exceeds
/// this many steps.
constexpr double rms_margin = 1.4;
constexpr double steps_margin = 3;
/// A believed reading leaves nothing but what rounding can cause, apart from the errors of its own
/// arithmetic.
constexpr double own_errors = 1.05;
/// A reading that is this much worse than the best one does not fit: the rms of some hundred cycles is hardly
/// luck.
constexpr double clearly_worse = 1.1;
/// If both the listed chain and a reading fit, the reading is believed if its error is smaller by this
/// factor.
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

/// Errors that rounding of the two columns explains.
struct Allowance {
  double input = 0, output = 0;  ///< their resolutions
  double noise = 0;
  [[nodiscard]] double rms(double gain = 1) const {
    return std::hypot(gain * input, output) / std::sqrt(12.0);
  }
  /// The least rms that a recording can measure: anything smaller is luck, as in slow motion, where both
  /// columns round alike.
  [[nodiscard]] double measurable(Residual const& residual) const {
    return std::max(residual.rms, output / std::sqrt(12.0));
  }
  [[nodiscard]] bool holds(Residual const& residual, double gain = 1) const {
    return residual.rms <= rms_margin * rms(gain) + noise &&
           residual.largest <= steps_margin * std::max(gain * input, output) + 10 * noise;
  }
  /// A chain that amplifies high frequencies amplifies the rounding errors of its input.
  [[nodiscard]] bool holds(Explained const& explained) const {
    constexpr double largest_gain = 10;
    if (holds(explained.residual)) return true;
    if (!holds(explained.residual, largest_gain)) return false;
    return holds(explained.residual, std::clamp(noise_gain(explained.reading.chain), 1.0, largest_gain));
  }
  /// The largest error that rounding of both columns explains, if the chain amplifies errors of its input by
  /// `worst_gain`.
  [[nodiscard]] double largest(double worst_gain) const { return (worst_gain * input + output) / 2; }
  [[nodiscard]] bool is_within_rounding(Explained const& explained) const {
    auto const is_below = [&](double bound) {
      return explained.residual.largest <= own_errors * bound + 10 * noise;
    };
    // A chain that passes a constant does not reduce a constant error.
    return is_below(largest(1)) || is_below(largest(worst_gain(explained.reading.chain)));
  }
  [[nodiscard]] bool explains(Explained const& explained) const {
    return holds(explained) && is_within_rounding(explained);
  }
};

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

/// The readings that the recording does not rule out; the best of the others becomes `next`. `found`: by
/// rising rms.
void explain(Comparison& comparison, std::vector<Explained> const& found, Allowance const& allowance) {
  for (auto const& one : found) {
    if (one.reading.departures.empty()) continue;
    auto& fitting = comparison.fitting;
    double const best = allowance.measurable(fitting.empty() ? one.residual : fitting.front().residual);
    bool const is_as_good = one.residual.rms <= clearly_worse * best + allowance.noise;
    if (is_as_good && allowance.explains(one)) {
      fitting.push_back(one);
    } else if (!comparison.next) {
      comparison.next = one;
    }
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
  comparison.allowed_largest = allowance.largest(worst_gain(all.front().chain));

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
  auto const found = tried(busiest_part(recording, longest), all, comparison.output_resolution);
  explain(comparison, found, allowance);
  if (!is_same || comparison.fitting.empty()) return comparison;
  auto const listed = std::find_if(found.begin(), found.end(),
                                   [](Explained const& one) { return one.reading.departures.empty(); });
  // The chain contains no fraction of a cycle: the error left by one is not rounding.
  double const delay = listed->residual.delay_cycles;
  bool const is_ruled_out = delay == std::round(delay) && !allowance.is_within_rounding(*listed);
  if (is_ruled_out ||
      allowance.measurable(comparison.fitting.front().residual) * believed_gain < comparison.listed.rms) {
    comparison.verdict = Verdict::different;
    return comparison;
  }
  std::erase_if(comparison.fitting, [&](Explained const& one) {
    return one.residual.rms > clearly_worse * allowance.measurable(comparison.listed) + allowance.noise;
  });
  return comparison;
}

}  // namespace axisc::comparison
