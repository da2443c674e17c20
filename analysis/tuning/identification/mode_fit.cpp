#include "analysis/tuning/identification/mode_fit.hpp"

#include "analysis/motion/least_squares.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace axisc::tuning {
namespace {

/// The points that count: those around the maximum that are above this share of it, at least `fewest`.
constexpr double counted_height = 0.35;
constexpr std::size_t fewest = 7;

struct Range {
  std::size_t first = 0, last = 0;
};

Range range_around(MeasuredResponse const& measured, std::size_t top, double share, std::size_t least) {
  double const limit = share * std::abs(measured.response[top]);
  Range range{.first = top, .last = top};
  auto const size = measured.response.size();
  auto const is_small = [&] { return range.last - range.first + 1 < least; };
  auto const counts = [&](std::size_t i) { return std::abs(measured.response[i]) >= limit; };
  while (range.first > 0 && (counts(range.first - 1) || is_small())) {
    --range.first;
    if (range.last + 1 < size && (counts(range.last + 1) || is_small())) ++range.last;
  }
  while (range.last + 1 < size && (counts(range.last + 1) || is_small())) ++range.last;
  return range;
}

/// The mode with these ω0² and 2 D ω0, in units of the peak's frequency.
std::optional<Mode> mode_of(double a0, double a1, double frequency) {
  if (!(a0 > 0.25) || !(a0 < 4) || !(a1 > 0)) return std::nullopt;
  double const natural = std::sqrt(a0);
  double const damping = a1 / 2 / natural;
  if (!(damping < 1)) return std::nullopt;
  return Mode{.frequency = natural * frequency, .damping = damping};
}

std::optional<Mode> with_phase(MeasuredResponse const& measured, Range const& range, std::size_t top) {
  motion::LeastSquares<6> squares;
  auto const height = std::abs(measured.response[top]);
  for (std::size_t i = range.first; i <= range.last; ++i) {
    double const w = measured.frequency[i] / measured.frequency[top];
    auto const h = measured.response[i] / height;
    // j w H has the real part -w Im H and the imaginary part w Re H.
    squares.add({h.real(), -w * h.imag(), -1, 0, 0, w}, w * w * h.real());
    squares.add({h.imag(), w * h.real(), 0, -1, -w, 0}, w * w * h.imag());
  }
  auto const found = squares.solve();
  return found ? mode_of((*found)[0], (*found)[1], measured.frequency[top]) : std::nullopt;
}

std::optional<Mode> of_magnitudes(MeasuredResponse const& measured, Range const& range, std::size_t top) {
  motion::LeastSquares<3> squares;
  for (std::size_t i = range.first; i <= range.last; ++i) {
    double const w = measured.frequency[i] / measured.frequency[top];
    double const power = std::norm(measured.response[i]) / std::norm(measured.response[top]);
    // Weighted by the power: what lies around the maximum counts.
    squares.add({power, power * w * w, power * w * w * w * w}, 1);
  }
  auto const found = squares.solve();
  if (!found) return std::nullopt;
  auto const& [p0, p1, p2] = *found;
  if (!(p2 > 0) || !(p0 > 0)) return std::nullopt;
  double const a0 = std::sqrt(p0 / p2);
  double const square = 2 * a0 + p1 / p2;
  return square > 0 ? mode_of(a0, std::sqrt(square), measured.frequency[top]) : std::nullopt;
}

}  // namespace

Mode fit_mode(MeasuredResponse const& measured, std::size_t top) {
  auto const range = range_around(measured, top, counted_height, fewest);
  auto const fitted =
      measured.has_phase ? with_phase(measured, range, top) : of_magnitudes(measured, range, top);
  if (fitted) return *fitted;
  constexpr double half_power = 0.70710678;
  auto const band = range_around(measured, top, half_power, 1);
  double const width = measured.frequency[band.last] - measured.frequency[band.first] + measured.resolution();
  return {.frequency = measured.frequency[top],
          .damping = std::min(0.5, width / 2 / measured.frequency[top])};
}

}  // namespace axisc::tuning
