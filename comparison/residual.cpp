#include "comparison/residual.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace axisc::comparison {

namespace {

constexpr int longest_lag = 10;
/// A fraction of a cycle is believed where it takes away at least this much.
constexpr double fraction_gain = 0.7;
/// Cycles behind a gap that do not count, if the chain settles more slowly.
constexpr std::size_t longest_shadow = 400;

bool is_multiple(double value, double step) {
  constexpr double tolerance = 1e-3;
  double const steps = value / step;
  return std::abs(steps - std::round(steps)) < tolerance;
}

/// `computed` at n - lag, within the recording.
struct Shifted {
  std::vector<double> const& values;
  int lag;
  [[nodiscard]] bool has(std::size_t n) const {
    auto const at = static_cast<std::ptrdiff_t>(n) - lag;
    return at >= 0 && at < static_cast<std::ptrdiff_t>(values.size());
  }
  double operator[](std::size_t n) const {
    return values[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(n) - lag)];
  }
};

struct Sums {
  double squares = 0, largest = 0;
  std::size_t count = 0;
  void add(double error) {
    squares += error * error;
    largest = std::max(largest, std::abs(error));
    ++count;
  }
  [[nodiscard]] Residual residual(double delay) const {
    return {delay, largest, count == 0 ? 0 : std::sqrt(squares / static_cast<double>(count))};
  }
};

Residual with_lag(std::vector<double> const& computed, std::vector<double> const& output,
                  std::vector<bool> const& counted, int lag) {
  Shifted const shifted{computed, lag};
  Sums sums;
  for (std::size_t n = 0; n < output.size(); ++n) {
    if (counted[n] && shifted.has(n)) sums.add(output[n] - shifted[n]);
  }
  return sums.residual(lag);
}

/// Between `lag` and the next cycle: the part of it with the smallest sum of squares.
Residual with_fraction(std::vector<double> const& computed, std::vector<double> const& output,
                       std::vector<bool> const& counted, int lag) {
  Shifted const early{computed, lag}, late{computed, lag + 1};
  double projection = 0, energy = 0;
  for (std::size_t n = 0; n < output.size(); ++n) {
    if (!counted[n] || !early.has(n) || !late.has(n)) continue;
    double const step = late[n] - early[n];
    projection += step * (output[n] - early[n]);
    energy += step * step;
  }
  double const part = energy > 0 ? std::clamp(projection / energy, 0.0, 1.0) : 0;
  Sums sums;
  for (std::size_t n = 0; n < output.size(); ++n) {
    if (counted[n] && early.has(n) && late.has(n)) {
      sums.add(output[n] - early[n] - part * (late[n] - early[n]));
    }
  }
  return sums.residual(lag + part);
}

}  // namespace

double resolution(std::span<double const> values, std::span<std::size_t const> gaps) {
  auto const fits = [&](double step) {
    auto gap = gaps.begin();
    for (std::size_t n = 0; n < values.size(); ++n) {
      if (gap != gaps.end() && *gap == n) {
        ++gap;
      } else if (!is_multiple(values[n], step)) {
        return false;
      }
    }
    return true;
  };
  for (double const step : {1.0, 0.1, 0.01, 1e-3, 1e-4, 1e-5, 1e-6}) {
    if (fits(step)) return step;
  }
  return 0;
}

std::vector<bool> counted_cycles(Recording const& recording, std::size_t settling) {
  auto const& output = recording.output;
  double const step = resolution(output, recording.gaps);
  std::vector<bool> counted(output.size(), false);
  auto const& input = recording.input;
  std::size_t begin = 0;
  while (begin < input.size() && input[begin] == input.front() &&
         std::abs(output[begin] - input.front()) <= step) {
    ++begin;
  }
  if (begin < 3) begin = settling;  // no rest at the start: the state is not known
  for (std::size_t n = std::max<std::size_t>(begin, 1); n < output.size(); ++n) {
    counted[n] = std::abs(output[n] - output[n - 1]) > step;
  }
  std::size_t const shadow = std::min(settling, longest_shadow);
  for (auto const gap : recording.gaps) {
    for (std::size_t n = gap; n < std::min(output.size(), gap + shadow + 1); ++n) counted[n] = false;
  }
  return counted;
}

Residual residual_of(std::vector<double> const& computed, std::vector<double> const& output,
                     std::vector<bool> const& counted, bool with_fractions) {
  Residual best = with_lag(computed, output, counted, 0);
  for (int distance = 1; distance <= longest_lag; ++distance) {
    for (int const lag : {distance, -distance}) {
      auto const other = with_lag(computed, output, counted, lag);
      if (other.rms < best.rms) best = other;
    }
  }
  if (!with_fractions) return best;
  auto const whole = static_cast<int>(best.delay_cycles);
  for (int const lag : {whole, whole - 1}) {
    auto const other = with_fraction(computed, output, counted, lag);
    if (other.rms < fraction_gain * best.rms) best = other;
  }
  return best;
}

}  // namespace axisc::comparison
