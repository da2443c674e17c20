// Smallest value of a function of a few variables without derivatives: the simplex method of Nelder and Mead
// (A simplex method for function minimization, Computer Journal 7, 1965).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace axisc::tuning {

template <std::size_t N>
struct Minimum {
  std::array<double, N> place{};
  double value = 0;
};

/// Begins with `start` and the points that are `steps` away from it, one variable each. Ends after
/// `evaluations`, or when the values differ by less than a 1e9th.
template <std::size_t N, class Function>
[[nodiscard]] Minimum<N> smallest(Function function, std::array<double, N> const& start,
                                  std::array<double, N> const& steps, std::size_t evaluations) {
  using Point = std::array<double, N>;
  std::array<Minimum<N>, N + 1> points{};
  for (std::size_t i = 0; i <= N; ++i) {
    points[i].place = start;
    if (i > 0) points[i].place[i - 1] += steps[i - 1];
    points[i].value = function(points[i].place);
  }
  auto const less = [](auto const& a, auto const& b) { return a.value < b.value; };
  for (std::size_t used = N + 1; used < evaluations;) {
    std::sort(points.begin(), points.end(), less);
    constexpr double close = 1e-9;
    if (points[N].value - points[0].value <= close * std::abs(points[0].value)) break;
    Point centre{};
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t k = 0; k < N; ++k) centre[k] += points[i].place[k] / static_cast<double>(N);
    }
    auto const moved = [&](double factor) {
      Minimum<N> point;
      for (std::size_t k = 0; k < N; ++k) {
        point.place[k] = centre[k] + factor * (points[N].place[k] - centre[k]);
      }
      point.value = function(point.place);
      ++used;
      return point;
    };
    auto const reflected = moved(-1);
    if (reflected.value < points[0].value) {
      auto const expanded = moved(-2);
      points[N] = expanded.value < reflected.value ? expanded : reflected;
    } else if (reflected.value < points[N - 1].value) {
      points[N] = reflected;
    } else {
      auto const contracted = moved(reflected.value < points[N].value ? -0.5 : 0.5);
      if (contracted.value < std::min(reflected.value, points[N].value)) {
        points[N] = contracted;
        continue;
      }
      for (std::size_t i = 1; i <= N; ++i) {
        for (std::size_t k = 0; k < N; ++k) {
          points[i].place[k] = points[0].place[k] + (points[i].place[k] - points[0].place[k]) / 2;
        }
        points[i].value = function(points[i].place);
        ++used;
      }
    }
  }
  return *std::min_element(points.begin(), points.end(), less);
}

}  // namespace axisc::tuning
