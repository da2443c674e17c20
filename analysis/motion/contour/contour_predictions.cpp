#include "analysis/motion/contour/contour_predictions.hpp"

#include "analysis/motion/contour/filtered_circle.hpp"
#include "analysis/motion/contour/nearest_point.hpp"
#include "analysis/motion/contour/plane.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace axisc::motion {
namespace {

/// y = v0 (n - D - r) + v1 r
double passed(ChainAnswer const& answer, double v0, double v1, double cycle) {
  double const r = answer.ramp_at(cycle);
  return v0 * (cycle - answer.delay - r) + v1 * r;
}

/// The filtered path around a corner at 0 that is passed at cycle 0, one point per cycle.
struct Corner {
  Point u0{}, u1{};
  double velocity = 0;

  [[nodiscard]] Point nominal(double cycle) const { return plus({}, velocity * cycle, cycle < 0 ? u0 : u1); }
  [[nodiscard]] Point filtered(Plane const& plane, double cycle) const {
    Point point{};
    point[0] = passed(plane.first, velocity * u0[0], velocity * u1[0], cycle);
    point[1] = passed(plane.second, velocity * u0[1], velocity * u1[1], cycle);
    return point;
  }
  /// From cycle `first` to cycle `last`, both whole.
  [[nodiscard]] std::vector<Point> path(Plane const& plane, double first, double last) const {
    std::vector<Point> points;
    auto const cycles = static_cast<int>(last - first);
    for (int n = 0; n <= cycles; ++n) points.push_back(filtered(plane, first + n));
    return points;
  }
};

ContourFigures measure(Corner const& corner, Plane const& plane) {
  auto const reach = static_cast<int>(std::ceil(plane.reach()));
  double const middle = std::round(plane.latest());
  int const first = -2 * reach;
  SearchedPath const path(corner.path(plane, middle + first, middle - first));
  ContourFigures figures;
  for (int n = -reach; n <= reach; ++n) {
    figures.take(path.nearest(corner.nominal(n), static_cast<std::size_t>(n - first)));
  }
  return figures;
}

/// Response at θ:  G = Σ b[n] e^(-jθn).
std::complex<double> gain(ChainAnswer const& answer, double theta) {
  auto const turn = std::polar(1.0, -theta);
  std::complex<double> phasor = 1;
  std::complex<double> sum = 0;
  for (std::size_t n = 0; n < answer.tap_count(); ++n) {
    sum += answer.tap(n) * phasor;
    phasor *= turn;
  }
  return sum;
}

/// From the nominal circle, of all points.
double largest_distance(FilteredCircle const& circle, double radius) {
  auto const [large, small] = circle.semi_axes();
  return std::max(std::abs(large - radius), std::abs(small - radius));
}

/// What an axis makes of a circle, seen `delay` cycles later.
std::complex<double> component(ChainAnswer const& answer, double delay, double velocity, double radius) {
  double const theta = velocity / radius;
  return radius * gain(answer, theta) * std::polar(1.0, theta * delay);
}

/// The delay of the first axis is not a deviation: both axes are measured from there.
FilteredCircle circle_in(Plane const& plane, double velocity, double radius) {
  return {.x = component(plane.first, plane.first.delay, velocity, radius),
          .y = component(plane.second, plane.first.delay, velocity, radius)};
}

/// Setpoints of half a circle of radius 1: the other half deviates in the same way.
std::vector<std::complex<double>> const& directions() {
  static auto const made = [] {
    constexpr int count = 3600;
    std::vector<std::complex<double>> setpoints;
    for (int i = 0; i < count / 2; ++i) {
      setpoints.push_back(std::polar(1.0, 2 * std::numbers::pi * i / count));
    }
    return setpoints;
  }();
  return made;
}

ContourFigures measure(FilteredCircle const& filtered, double radius) {
  auto const& [x, y] = filtered;
  ContourFigures figures;
  if (x == y) {
    figures.deviation = std::abs(std::abs(x) - radius);
    figures.axis_error[0] = figures.axis_error[1] = figures.deviation;
    return figures;
  }
  for (auto const& setpoint : directions()) {
    Point const point = filtered.at(setpoint);
    double const px = point[0];
    double const py = point[1];
    double const distance = std::hypot(px, py);
    double const share = distance > 0 ? 1 - radius / distance : 1;
    figures.deviation = std::max(figures.deviation, std::abs(distance - radius));
    figures.axis_error[0] = std::max(figures.axis_error[0], std::abs(px * share));
    figures.axis_error[1] = std::max(figures.axis_error[1], std::abs(py * share));
  }
  return figures;
}

ContourFigures parallel(Plane const& plane, double velocity) {
  auto const reach = static_cast<int>(std::ceil(plane.reach()));
  Corner const there{.u0 = {1, 0}, .u1 = {0, 1}, .velocity = velocity};
  Corner const back{.u0 = {0, -1}, .u1 = {-1, 0}, .velocity = velocity};
  double const middle = std::round(plane.latest());
  SearchedPath const way_back(back.path(plane, middle - 3 * reach, middle + 3 * reach));
  ContourFigures figures;
  for (int n = -reach; n <= reach; ++n) {
    figures.take(
        way_back.nearest(there.filtered(plane, middle + n), static_cast<std::size_t>(3 * reach - n)));
  }
  return figures;
}

}  // namespace

double ContourFigures::largest_axis_error() const {
  return *std::max_element(axis_error.begin(), axis_error.end());
}

void ContourFigures::take(NearestPoint const& nearest) {
  deviation = std::max(deviation, nearest.distance());
  for (std::size_t i = 0; i < most_axes; ++i) {
    axis_error[i] = std::max(axis_error[i], std::abs(nearest.away[i]));
  }
}

ContourFigures predict_corner(std::span<ChainAnswer const> answers, double velocity, double turn) {
  Corner corner{.u0 = {1, 0}, .u1 = {std::cos(turn), std::sin(turn)}, .velocity = velocity};
  return over_planes(answers, [&](Plane const& plane, std::size_t) { return measure(corner, plane); });
}

ContourFigures predict_line(std::span<ChainAnswer const> answers, double velocity) {
  double const share = std::numbers::sqrt2 / 2;
  Corner const straight{.u0 = {share, share}, .u1 = {share, share}, .velocity = velocity};
  return over_planes(answers, [&](Plane const& plane, std::size_t) { return measure(straight, plane); });
}

ContourFigures predict_circle(std::span<ChainAnswer const> answers, double velocity, double radius) {
  return over_planes(answers, [&](Plane const& plane, std::size_t) {
    return measure(circle_in(plane, velocity, radius), radius);
  });
}

double largest_circle_error(std::span<ChainAnswer const> answers, double velocity, double radius) {
  std::vector<FilteredCircle> circles;
  auto const x = component(answers[0], answers[0].delay, velocity, radius);
  for (auto const& other : answers.subspan(answers.size() == 1 ? 0 : 1)) {
    circles.push_back({.x = x, .y = component(other, answers[0].delay, velocity, radius)});
  }
  std::sort(circles.begin(), circles.end(), [radius](FilteredCircle const& a, FilteredCircle const& b) {
    return largest_distance(a, radius) > largest_distance(b, radius);
  });
  double largest = 0;
  for (auto const& one : circles) {
    // No axis deviates by more than the path does.
    if (largest_distance(one, radius) <= largest) break;
    largest = std::max(largest, measure(one, radius).largest_axis_error());
  }
  return largest;
}

double predict_parallel(std::span<ChainAnswer const> answers, double velocity) {
  auto const figures =
      over_planes(answers, [&](Plane const& plane, std::size_t) { return parallel(plane, velocity); });
  return figures.deviation;
}

std::vector<Point> corner_path(ChainAnswer const& first, ChainAnswer const& second, double velocity,
                               double turn) {
  Corner const corner{.u0 = {1, 0}, .u1 = {std::cos(turn), std::sin(turn)}, .velocity = velocity};
  Plane const plane{.first = first, .second = second};
  double const reach = std::ceil(plane.reach());
  double const middle = std::round(plane.latest());
  return corner.path(plane, middle - 2 * reach, middle + 2 * reach);
}

std::vector<Point> circle_path(ChainAnswer const& first, ChainAnswer const& second, double velocity,
                               double radius, std::size_t points) {
  auto const filtered = circle_in({.first = first, .second = second}, velocity, radius);
  std::vector<Point> path;
  for (std::size_t i = 0; i < points; ++i) {
    double const angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
    path.push_back(filtered.at(std::polar(1.0, angle)));
  }
  return path;
}

}  // namespace axisc::motion
