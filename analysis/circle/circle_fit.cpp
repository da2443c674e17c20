#include "analysis/circle/circle_fit.hpp"

#include "analysis/motion/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace axisc::circle {

namespace {

constexpr FittedCircle no_circle{.u = std::numeric_limits<double>::quiet_NaN(),
                                 .v = std::numeric_limits<double>::quiet_NaN(),
                                 .radius = std::numeric_limits<double>::quiet_NaN()};

/// Without iteration, Σ w (u² + v² - 2au - 2bv - c)² → min, about the mean and in units of the spread.
FittedCircle algebraic(std::span<Sample const> samples) {
  double sum = 0, u = 0, v = 0;
  for (auto const& each : samples) {
    sum += each.weight;
    u += each.weight * each.u;
    v += each.weight * each.v;
  }
  u /= sum;
  v /= sum;
  double spread = 0;
  for (auto const& each : samples) spread = std::max(spread, std::hypot(each.u - u, each.v - v));
  motion::LeastSquares<3> squares;
  for (auto const& each : samples) {
    double const x = (each.u - u) / spread;
    double const y = (each.v - v) / spread;
    squares.add({2 * x, 2 * y, 1}, x * x + y * y, each.weight / sum);
  }
  auto const found = squares.solve();
  if (!found) return no_circle;
  auto const& [a, b, c] = *found;
  return {.u = u + a * spread, .v = v + b * spread, .radius = std::sqrt(c + a * a + b * b) * spread};
}

}  // namespace

FittedCircle fit_circle(std::span<Sample const> samples) {
  auto circle = algebraic(samples);
  constexpr int most_steps = 30;
  constexpr double negligible = 1e-13;
  for (int step = 0; step < most_steps && std::isfinite(circle.radius); ++step) {
    // Gauss-Newton:  |p - c| - r  changes by  -cos φ da - sin φ db - dr.
    motion::LeastSquares<3> squares;
    for (auto const& each : samples) {
      double const x = each.u - circle.u;
      double const y = each.v - circle.v;
      double const distance = std::hypot(x, y);
      if (distance > 0) squares.add({x / distance, y / distance, 1}, distance - circle.radius, each.weight);
    }
    auto const found = squares.solve();
    if (!found) return no_circle;
    auto const& [da, db, dr] = *found;
    circle.u += da;
    circle.v += db;
    circle.radius += dr;
    if (std::abs(da) + std::abs(db) + std::abs(dr) < negligible * circle.radius) break;
  }
  return circle;
}

}  // namespace axisc::circle
