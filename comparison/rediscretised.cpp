#include "comparison/rediscretised.hpp"

#include <array>
#include <cmath>
#include <complex>

namespace axisc::comparison {

namespace {

/// Coefficients by rising power: of z^-1, or of u = sT/2.
using Polynomial = std::array<double, 3>;

struct Fraction {
  Polynomial numerator{}, denominator{};
  bool first_order = false;
};

Fraction direct(design::IncrementSection const& s, bool blocks_constant) {
  double const a2 = 1 - s.b;
  double const a1 = s.k - 1 - a2;
  bool const first_order = s.b == 1 && s.q == 0;
  if (blocks_constant) return {{s.p, s.q - s.p, -s.q}, {1, a1, a2}, first_order};
  return {{1 + s.p, s.q - s.p + a1, a2 - s.q}, {1, a1, a2}, first_order};
}

/// z^-1 = (1 - u)/(1 + u)
Polynomial analogue(Polynomial const& c, bool first_order) {
  if (first_order) return {c[0] + c[1], c[0] - c[1], 0};
  return {c[0] + c[1] + c[2], 2 * (c[0] - c[2]), c[0] - c[1] + c[2]};
}

/// u = (1 - z^-1)/2
Polynomial backward(Polynomial const& a) {
  return {a[0] + a[1] / 2 + a[2] / 4, -a[1] / 2 - a[2] / 2, a[2] / 4};
}

/// u = (1 - z^-1)/(2 z^-1)
Polynomial forward(Polynomial const& a, bool first_order) {
  if (first_order) return {a[1] / 2, a[0] - a[1] / 2, 0};
  return {a[2] / 4, a[1] / 2 - a[2] / 2, a[0] - a[1] / 2 + a[2] / 4};
}

/// Roots u become exp(2u); roots at infinity become -1, or are left out.
Polynomial matched(Polynomial const& a, bool keeps_infinite) {
  constexpr double nothing = 1e-7;
  double const size = std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2]);
  bool const has_two = std::abs(a[2]) > nothing * size;
  bool const has_one = std::abs(a[1]) > nothing * size;
  if (has_two) {
    auto const root = std::sqrt(std::complex<double>(a[1] * a[1] - 4 * a[2] * a[0]));
    auto const one = std::exp((-a[1] + root) / a[2]);
    auto const other = std::exp((-a[1] - root) / a[2]);
    return {1, -(one + other).real(), (one * other).real()};
  }
  if (has_one) {
    double const z = std::exp(-2 * a[0] / a[1]);
    return {1, -z, 0};
  }
  return {1, keeps_infinite ? 1.0 : 0.0, 0};
}

/// How many roots the polynomial has fewer than `degree`, of which matched() makes one zero at -1 each.
Polynomial matched_numerator(Polynomial const& a, bool first_order, bool keeps_infinite) {
  auto const zeros = matched(a, keeps_infinite);
  bool const has_no_zero = zeros[2] == 0 && (zeros[1] == 0 || zeros[1] == 1);
  if (first_order || !keeps_infinite) return zeros;
  if (has_no_zero) return {1, 2, 1};
  if (zeros[2] == 0) return {1, zeros[1] + 1, zeros[1]};
  return zeros;
}

Fraction transformed(Fraction const& digital, Discretisation discretisation) {
  bool const first = digital.first_order;
  auto const numerator = analogue(digital.numerator, first);
  auto const denominator = analogue(digital.denominator, first);
  if (discretisation == Discretisation::backward_euler) {
    return {backward(numerator), backward(denominator), first};
  }
  if (discretisation == Discretisation::forward_euler) {
    return {forward(numerator, first), forward(denominator, first), first};
  }
  bool const keeps_infinite = discretisation == Discretisation::matched;
  Fraction made{matched_numerator(numerator, first, keeps_infinite), matched(denominator, false), first};
  auto const at_one = [](Polynomial const& c) { return c[0] + c[1] + c[2]; };
  double const gain = at_one(made.denominator) / at_one(made.numerator);
  for (double& c : made.numerator) c *= gain;
  return made;
}

design::IncrementSection increments(Fraction const& f, bool blocks_constant) {
  double const scale = f.denominator[0];
  double const b0 = f.numerator[0] / scale, b1 = f.numerator[1] / scale;
  double const a1 = f.denominator[1] / scale, a2 = f.denominator[2] / scale;
  if (blocks_constant) return {.p = b0, .q = b0 + b1, .k = 1 + a1 + a2, .b = 1 - a2};
  return {.p = b0 - 1, .q = b0 - 1 + b1 - a1, .k = 1 + a1 + a2, .b = 1 - a2};
}

}  // namespace

std::optional<Link> rediscretised(Link const& bilinear, Discretisation discretisation) {
  bool const is_matched =
      discretisation == Discretisation::matched || discretisation == Discretisation::matched_poles;
  if (bilinear.sections.empty() || (is_matched && bilinear.blocks_constant)) return std::nullopt;
  Link made = bilinear;
  for (auto& section : made.sections) {
    section = increments(transformed(direct(section, bilinear.blocks_constant), discretisation),
                         bilinear.blocks_constant);
    bool const is_finite = std::isfinite(section.p) && std::isfinite(section.q);
    if (!is_finite || !design::is_loadable(section)) return std::nullopt;
  }
  return made;
}

}  // namespace axisc::comparison
