#include "plain_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace axisc::test {
namespace {

constexpr double pi = std::numbers::pi;

template <class Tap>
std::vector<double> symmetric(int order, Tap tap) {
  int const h = (order + 1) / 2;
  std::vector<double> taps;
  double sum = 0;
  for (int k = -h; k <= h; ++k) {
    taps.push_back(tap(k, h));
    sum += taps.back();
  }
  for (auto& b : taps) b /= sum;
  return taps;
}

double distance(Place const& a, Place const& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

Place between(Place const& a, Place const& b, double share) {
  Place p{};
  for (std::size_t i = 0; i < a.size(); ++i) p[i] = a[i] + share * (b[i] - a[i]);
  return p;
}

/// Where the foot of the perpendicular from p on a..b lies, kept within the line.
double foot(Place const& p, Place const& a, Place const& b) {
  double along = 0;
  double squared = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    along += (p[i] - a[i]) * (b[i] - a[i]);
    squared += (b[i] - a[i]) * (b[i] - a[i]);
  }
  return squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
}

/// A place of the contour: line, and share of it.
struct OnContour {
  std::size_t line = 0;
  double share = 0;
};

/// The first place from `from` on where the setpoint lies.
OnContour place_of(std::vector<Place> const& contour, Place const& setpoint, OnContour from) {
  for (std::size_t line = from.line; line + 1 < contour.size(); ++line) {
    double const share = foot(setpoint, contour[line], contour[line + 1]);
    if (line == from.line && share < from.share - 1e-9) continue;
    if (distance(between(contour[line], contour[line + 1], share), setpoint) < 1e-6) return {line, share};
  }
  return from;
}

}  // namespace

std::vector<double> average_taps(int order) {
  return symmetric(order, [](int, int) { return 1.0; });
}

std::vector<double> gaussian_taps(int order, double quality) {
  return symmetric(order, [&](int k, int h) {
    double const x = 2.5 * k / (quality * h);
    return std::exp(-x * x / 2);
  });
}

std::vector<double> sinc_taps(int order, double frequency_hz, double cycle_seconds) {
  return symmetric(order, [&](int k, int h) {
    double const x = 2 * pi * frequency_hz * cycle_seconds * k;
    return (k == 0 ? 1 : std::sin(x) / x) * (0.54 + 0.46 * std::cos(pi * k / h));
  });
}

std::vector<double> delay_taps(int cycles) {
  std::vector<double> taps(static_cast<std::size_t>(cycles) + 1, 0.0);
  taps.back() = 1;
  return taps;
}

std::vector<double> pt1_taps(double time_constant_us, double cycle_seconds) {
  double const tau = time_constant_us * 1e-6;
  // s → c (1 - z^-1)/(1 + z^-1) with c such that the corner frequency stays in its place
  double const c = 1 / std::tan(cycle_seconds / (2 * tau));
  double const pole = (c - 1) / (c + 1);
  double const gain = 1 / (c + 1);
  std::vector<double> taps = {gain};
  double rest = gain * (1 + pole);
  while (rest > 1e-16) {
    taps.push_back(rest);
    rest *= pole;
  }
  return taps;
}

std::vector<double> in_series(std::vector<double> const& a, std::vector<double> const& b) {
  std::vector<double> taps(a.size() + b.size() - 1, 0.0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) taps[i + k] += a[i] * b[k];
  }
  return taps;
}

std::vector<Place> convolved(std::vector<Place> const& setpoints, Place const& start,
                             std::vector<std::vector<double>> const& taps) {
  std::vector<Place> filtered(setpoints.size(), Place{});
  for (std::size_t n = 0; n < setpoints.size(); ++n) {
    for (std::size_t i = 0; i < taps.size(); ++i) {
      double sum = 0;
      for (std::size_t k = 0; k < taps[i].size(); ++k) {
        sum += taps[i][k] * (k <= n ? setpoints[n - k][i] - start[i] : 0);
      }
      filtered[n][i] = start[i] + sum;
    }
  }
  return filtered;
}

double Distances::largest() const {
  return *std::max_element(axis_error.begin(), axis_error.end());
}

std::vector<Distances> distances(std::vector<Place> const& contour, std::vector<Place> const& given,
                                 std::vector<std::vector<double>> const& taps, int points_between) {
  std::size_t longest = 0;
  for (auto const& axis : taps) longest = std::max(longest, axis.size());
  // The axes rest before and after.
  std::vector<Place> setpoints(1, contour.front());
  setpoints.insert(setpoints.end(), given.begin(), given.end());
  setpoints.insert(setpoints.end(), longest + 1, setpoints.back());
  auto const filtered = convolved(setpoints, contour.front(), taps);

  std::vector<double> ways = {0};
  for (std::size_t n = 1; n < filtered.size(); ++n) {
    ways.push_back(ways.back() + distance(filtered[n - 1], filtered[n]));
  }
  std::vector<Distances> found(contour.size() - 1);
  auto const look = [&](std::size_t line, Place const& point, std::size_t cycle) {
    std::size_t const first = cycle > longest ? cycle - longest : 0;
    std::size_t const last = std::min(filtered.size() - 1, cycle + longest + longest / 2 + 2);
    double best = std::numeric_limits<double>::infinity();
    Place nearest{};
    for (std::size_t n = first; n < last;) {
      Place const here = between(filtered[n], filtered[n + 1], foot(point, filtered[n], filtered[n + 1]));
      double const away = distance(here, point);
      if (away < best) {
        best = away;
        nearest = here;
      }
      // So far along the path nothing can be nearer.
      double const spare = (distance(filtered[n + 1], point) - best) * (1 - 1e-9);
      ++n;
      auto const next =
          std::lower_bound(ways.begin() + static_cast<std::ptrdiff_t>(n), ways.end(), ways[n] + spare);
      n = std::max(n, static_cast<std::size_t>(next - ways.begin()) - 1);
    }
    found[line].deviation = std::max(found[line].deviation, best);
    for (std::size_t i = 0; i < point.size(); ++i) {
      found[line].axis_error[i] = std::max(found[line].axis_error[i], std::abs(nearest[i] - point[i]));
    }
  };
  OnContour at;
  for (std::size_t n = 0; n + 1 < setpoints.size(); ++n) {
    OnContour const next = place_of(contour, setpoints[n + 1], at);
    // Piece by piece from this setpoint to the next.
    for (std::size_t line = at.line; line <= next.line; ++line) {
      double const from = line == at.line ? at.share : 0;
      double const to = line == next.line ? next.share : 1;
      for (int i = 0; i <= points_between + 1; ++i) {
        double const share = from + (to - from) * i / (points_between + 1);
        look(line, between(contour[line], contour[line + 1], share), n);
      }
    }
    at = next;
  }
  return found;
}

Distances largest_of(std::vector<Distances> const& all) {
  Distances largest;
  for (auto const& here : all) {
    largest.deviation = std::max(largest.deviation, here.deviation);
    for (std::size_t i = 0; i < here.axis_error.size(); ++i) {
      largest.axis_error[i] = std::max(largest.axis_error[i], here.axis_error[i]);
    }
  }
  return largest;
}

}  // namespace axisc::test
