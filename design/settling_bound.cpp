#include "design/filter_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <initializer_list>
#include <limits>
#include <utility>

namespace axisc::design {
namespace {

/// A circle |z| = radius < 1 around all poles; w = z^-1 has the absolute value 1/radius there.
struct Circle {
  double radius = 1;
  double inverse = 1;
};

/// min |(1 - p1 w)(1 - p2 w)| on the circle. For p = ρ a exp(±jθ) the square is a parabola in the cosine of
/// the circle's angle, whose vertex is at (1 + a²) cos θ / 2a.
double least_denominator(IncrementSection const& section, Circle circle) {
  auto const [first, second] = poles(section);
  double const a = std::abs(first) * circle.inverse;
  if (first.imag() == 0) return (1 - a) * (1 - std::abs(second) * circle.inverse);
  double const cosine = first.real() / std::abs(first);
  double const vertex = (1 + a * a) * std::abs(cosine) / (2 * a);
  if (vertex <= 1) return (1 - a * a) * std::sqrt(1 - cosine * cosine);
  return 1 + a * a - 2 * a * std::abs(cosine);
}

/// |H| on the circle is at most this. The textbook's numerator is the smaller one for low-passes, that of the
/// increment form for narrow filters, through which most passes unchanged.
double most_of_section(IncrementSection const& section, bool blocks_constant, Circle circle) {
  double const denominator = least_denominator(section, circle);
  // Rounding may split a double pole, so that one of the two is outside.
  if (!(denominator > 0)) return std::numeric_limits<double>::infinity();
  double const w = circle.inverse;
  double const increment = (std::abs(section.p) + std::abs(section.q) * w) * (1 + w) / denominator;
  DirectSection const direct = direct_form(section, blocks_constant);
  double const rounding = 8 * std::numeric_limits<double>::epsilon() * (1 + w + w * w);
  double const numerator =
      std::abs(direct.b0) + std::abs(direct.b1) * w + std::abs(direct.b2) * w * w + rounding;
  return std::min(increment + (blocks_constant ? 0 : 1), numerator / denominator);
}

double most_of_filter(FilterDesign const& filter, Circle circle) {
  switch (filter.realisation) {
    case Realisation::pass_through: return 1;
    case Realisation::delay:
      return std::abs(filter.share.direct) +
             std::abs(filter.share.filtered) * std::pow(circle.inverse, filter.delay_cycles);
    case Realisation::sections: break;
  }
  double most = 1;
  for (IncrementSection const& section : filter.sections) {
    most *= most_of_section(section, filter.blocks_constant, circle);
  }
  return std::abs(filter.share.direct) + std::abs(filter.share.filtered) * most;
}

/// E(z) = (H(1) - H(z))/(1 - z^-1) is the z-transform of the distance to the final value: |e[n]| ≤ ρ^n max
/// |E(ρ exp(jφ))|.
double bound_on(Circle circle, std::span<FilterDesign const> chain, double tolerance) {
  double most = 1, final_value = 1;
  for (FilterDesign const& filter : chain) {
    most *= most_of_filter(filter, circle);
    final_value *= filter.dc_gain;
  }
  double const error = (std::abs(final_value) + most) / (circle.inverse - 1);
  double const cycles = std::log(tolerance / error) / std::log(circle.radius);
  return cycles < 0 ? 0 : cycles;  // NaN stays NaN
}

}  // namespace

double settling_bound(std::span<FilterDesign const> chain, double tolerance, double enough) {
  double bound = std::numeric_limits<double>::infinity();
  double pole_radius = 0;
  for (FilterDesign const& filter : chain) pole_radius = std::max(pole_radius, filter.pole_radius);
  if (pole_radius >= 1) return bound;
  // The closer to the poles, the faster the distance shrinks, and the larger it may be at first.
  for (double const share : {0.7, 0.5, 0.85, 0.95}) {
    double const radius = 1 - share * (1 - pole_radius);
    double const candidate = bound_on({.radius = radius, .inverse = 1 / radius}, chain, tolerance);
    if (candidate < bound) bound = candidate;
    if (bound <= enough) break;
  }
  return bound;
}

}  // namespace axisc::design
