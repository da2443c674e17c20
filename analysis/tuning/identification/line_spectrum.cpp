#include "analysis/tuning/identification/line_spectrum.hpp"

#include "analysis/motion/least_squares.hpp"
#include "analysis/motion/statistics.hpp"
#include "analysis/tuning/identification/fourier.hpp"
#include "analysis/tuning/identification/thresholds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace axisc::tuning {
namespace {

/// Entries on either side that belong to the line itself, with a Hann window.
constexpr std::size_t lobe = 2;
/// Of the neighbours on one side alone, so that the foot of a slope is not a line (6 dB).
constexpr double side_height = 4;
constexpr std::size_t fewest_on_a_side = 3;

std::vector<double> powers(std::span<double const> signal) {
  auto const count = static_cast<double>(signal.size());
  auto const place = [count](std::size_t n) { return static_cast<double>(n) / count; };
  motion::LeastSquares<2> squares;
  double largest = 0;
  for (double const value : signal) largest = std::max(largest, std::abs(value));
  if (!(largest > 0)) largest = 1;
  for (std::size_t n = 0; n < signal.size(); ++n) squares.add({1, place(n)}, signal[n] / largest);
  auto const line = squares.solve().value_or(std::array<double, 2>{});
  std::vector<std::complex<double>> values;
  for (std::size_t n = 0; n < signal.size(); ++n) {
    double const window = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * place(n));
    values.emplace_back(window * (signal[n] - largest * (line[0] + line[1] * place(n))));
  }
  transform(values);
  std::vector<double> power(values.size() / 2);
  for (std::size_t k = 0; k < power.size(); ++k) power[k] = std::norm(values[k]);
  return power;
}

/// Entries from `first` up to `end`, as many as there are.
std::vector<double> part(std::vector<double> const& power, std::ptrdiff_t first, std::ptrdiff_t end) {
  first = std::max<std::ptrdiff_t>(first, 1);
  end = std::min(end, static_cast<std::ptrdiff_t>(power.size()));
  if (first >= end) return {};
  return {power.begin() + first, power.begin() + end};
}

/// By which factor a place rises from its neighbours; 0 where there are too few of them.
double rise(std::vector<double> const& power, std::size_t k) {
  auto const at = static_cast<std::ptrdiff_t>(k);
  constexpr auto side = static_cast<std::ptrdiff_t>(line_neighbours / 2);
  constexpr auto own = static_cast<std::ptrdiff_t>(lobe);
  auto below = part(power, at - own - side, at - own);
  auto const above = part(power, at + own + 1, at + own + 1 + side);
  if (below.size() < fewest_on_a_side || above.size() < fewest_on_a_side) return 0;
  if (power[k] < side_height * std::max(motion::median(below), motion::median(above))) return 0;
  below.insert(below.end(), above.begin(), above.end());
  double const middle = motion::median(std::move(below));
  return middle > 0 ? power[k] / middle : 0;
}

}  // namespace

std::vector<Line> lines_of(std::span<double const> signal, double sampling_rate, double lowest,
                           double highest) {
  auto const power = powers(signal);
  auto const count = static_cast<double>(signal.size());
  double const step = sampling_rate / count;
  std::vector<Line> lines;
  std::size_t last = 0;
  double energy = 0, moment = 0, highest_rise = 0;
  auto const finish = [&] {
    double const frequency = energy > 0 ? moment / energy * step : 0;
    // A sine of amplitude A has Σ |X|² = 3/8 A² N²/4 over its lobe on either side of 0 Hz.
    constexpr double share = 3.0 / 32;
    if (highest_rise >= line_height && frequency >= lowest && frequency <= highest) {
      lines.push_back({.frequency = frequency, .amplitude = std::sqrt(energy / share) / count});
    }
    energy = moment = highest_rise = 0;
  };
  for (std::size_t k = 1; k + 1 < power.size(); ++k) {
    double const here = rise(power, k);
    if (here < side_height) continue;
    if (k > last + lobe) finish();
    energy += power[k];
    moment += power[k] * static_cast<double>(k);
    highest_rise = std::max(highest_rise, here);
    last = k;
  }
  finish();
  return lines;
}

}  // namespace axisc::tuning
