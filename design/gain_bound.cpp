#include "design/gain_bound.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace axisc::design {
namespace {

constexpr double unit_roundoff = 0x1p-53;

/// Margin for the rounding errors of the computation below: sums of up to 2^21 terms, and powers of a matrix
/// whose poles are 1e-9 or more away from the unit circle.
constexpr double outwards = 1 + 0x1p-18;

constexpr std::uint64_t longest_walk = std::uint64_t{1} << 21U;
constexpr std::uint64_t steps_between_checks = 32;
constexpr double contracted = 0x1p-4;

/// States of a section that is left alone, and the sums of their magnitudes:
///     e' = e + r,  r' = r - b r - k e'
struct Walk {
  double e, r;
  double sum_e = 0, sum_r = 0;

  void step(double k, double b) {
    sum_e += std::abs(e);
    sum_r += std::abs(r);
    e += r;
    r = (r - b * r) - k * e;
  }
};

/// Rows act on e and r.
struct Matrix {
  double ee, er, re, rr;

  friend Matrix operator*(Matrix const& x, Matrix const& y) {
    return {x.ee * y.ee + x.er * y.re, x.ee * y.er + x.er * y.rr, x.re * y.ee + x.rr * y.re,
            x.re * y.er + x.rr * y.rr};
  }
  friend Matrix operator+(Matrix const& x, Matrix const& y) {
    return {x.ee + y.ee, x.er + y.er, x.re + y.re, x.rr + y.rr};
  }
};

/// With √k e in place of e, both states of an oscillation are of one size.
Matrix scaled(Matrix const& x, double root_k) {
  return {x.ee, x.er * root_k, x.re / root_k, x.rr};
}
Matrix unscaled(Matrix const& x, double root_k) {
  return {x.ee, x.er / root_k, x.re * root_k, x.rr};
}
double row_norm(Matrix const& x) {
  return std::max(std::abs(x.ee) + std::abs(x.er), std::abs(x.re) + std::abs(x.rr));
}
Matrix magnitudes(Matrix const& x, double error) {
  return {std::abs(x.ee) + error, std::abs(x.er) + error, std::abs(x.re) + error, std::abs(x.rr) + error};
}

/// Σ|A^n| over all n, from the sum of the first m and from A^m. Doubling m until A^m is small,
///     Σ_{n<2m} |A^n| <= Σ_{n<m} |A^n| (1 + |A^m|)
/// and then, with its row norm ε, what is left adds to an element at most its row's sum times ε/(1 - ε).
Matrix completed(Matrix sum, Matrix power) {
  constexpr int most_doublings = 48;
  double error = 0;  // of each element of the power
  for (int i = 0; i < most_doublings; ++i) {
    Matrix const above = magnitudes(power, error);
    double const norm = row_norm(above);
    if (norm <= contracted) {
      double const factor = norm / (1 - norm);
      double const of_e = (sum.ee + sum.er) * factor;
      double const of_r = (sum.re + sum.rr) * factor;
      return sum + Matrix{of_e, of_e, of_r, of_r};
    }
    sum = sum + sum * above;
    error = 2 * norm * error + 4 * unit_roundoff * norm * norm;
    power = power * power;
  }
  constexpr double infinite = std::numeric_limits<double>::infinity();
  return {infinite, infinite, infinite, infinite};
}

/// The bounds of one section. Rounding of a cycle of
///     de = p d + r,  e += de,  r = de + q d - k e - b de
/// acts as an addition to r (also if it is one to de: both enter the next r), or to e.
SectionGain section_gain(IncrementSection const& section, bool blocks_constant) {
  auto const [p, q, k, b] = section;
  double const root_k = std::sqrt(k);
  Walk of_e{.e = 1, .r = 0};
  Walk of_r{.e = 0, .r = 1};
  Walk of_impulse{.e = p, .r = (p + q) - (k + b) * p};
  Matrix power{};
  for (std::uint64_t n = 0; n < longest_walk; n += steps_between_checks) {
    for (std::uint64_t i = 0; i < steps_between_checks; ++i) {
      of_e.step(k, b);
      of_r.step(k, b);
      of_impulse.step(k, b);
    }
    power = scaled({of_e.e, of_r.e, of_e.r, of_r.r}, root_k);
    if (row_norm(power) <= contracted) break;
  }
  Matrix const first = scaled({of_e.sum_e, of_r.sum_e, of_e.sum_r, of_r.sum_r}, root_k);
  Matrix const all = unscaled(completed(first, power), root_k);
  double const left_e = std::abs(of_impulse.e);
  double const left_r = std::abs(of_impulse.r);
  double const sum_e = (of_impulse.sum_e + all.ee * left_e + all.er * left_r) * outwards;
  double const sum_r = (of_impulse.sum_r + all.re * left_e + all.rr * left_r) * outwards;
  double const sum_de = std::abs(p) + sum_r;

  SectionGain gain;
  gain.passed = (blocks_constant ? std::abs(p) : std::abs(1 + p)) + sum_r;
  gain.per_e = all.re * outwards;
  gain.per_r = all.rr * outwards;
  double const into_e = sum_e;
  double const into_r =
      (std::abs(p) + sum_de) + (3 * std::abs(q) + 2 * sum_de + 2 * k * sum_e + b * sum_de + sum_r);
  gain.rounding =
      unit_roundoff * outwards *
      (into_e * (gain.per_e + k * gain.per_r) + into_r * gain.per_r + (blocks_constant ? 0 : gain.passed));
  return gain;
}

}  // namespace

FilterGain filter_gain(FilterDesign const& filter) {
  constexpr double of_share = 4 * unit_roundoff;
  FilterGain gain;
  if (filter.realisation == Realisation::pass_through) return gain;
  if (filter.realisation == Realisation::delay) {
    if (filter.share.filtered != 1) gain.rounding = 2 * of_share;
    return gain;
  }
  for (IncrementSection const& section : filter.sections) {
    SectionGain const& added = gain.sections.emplace_back(section_gain(section, filter.blocks_constant));
    gain.rounding = gain.rounding * added.passed + gain.passed * added.rounding;
    gain.passed *= added.passed;
  }
  double const within = gain.passed;
  gain.passed = (filter.share.filtered * within + filter.share.direct) * outwards;
  gain.rounding = filter.share.filtered * gain.rounding + of_share * (within + 1);
  return gain;
}

}  // namespace axisc::design
