#include "runtime/bounds/section_bound.hpp"

#include "runtime/bounds/outward.hpp"
#include "runtime/bounds/pole_radius.hpp"
#include "runtime/twofold.hpp"

namespace axisc::runtime::bounds {
namespace {

constexpr uint32_t cycles_of_walk = 16;
constexpr double shrunk = 0x1p-24;
constexpr double shrunk_with_rounding = 0x1p-23;
/// What roundings of a cycle add to the scaled states, for every unit of their sum.
constexpr double rounding_of_cycle = 12 * unit_roundoff;
constexpr double most_rounding = 0x1p-25;
constexpr double outwards = 1 + 0x1p-18;

/// States that are left alone, and the sums of their magnitudes.
struct Walk {
  double e, r;
  double sum_e = 0, sum_r = 0, change = 0;

  void step(double k, double b) {
    sum_e += magnitude(e);
    sum_r += magnitude(r);
    e += r;
    double const next = (r - b * r) - k * e;
    change += magnitude(next - r);
    r = next;
  }
};

/// Rows act on s e and r.
struct Matrix {
  double ee, er, re, rr;
};

Matrix product(Matrix const& x, Matrix const& y) {
  return {x.ee * y.ee + x.er * y.re, x.ee * y.er + x.er * y.rr, x.re * y.ee + x.rr * y.re,
          x.re * y.er + x.rr * y.rr};
}

Matrix magnitudes(Matrix const& x, double more) {
  return {magnitude(x.ee) + more, magnitude(x.er) + more, magnitude(x.re) + more, magnitude(x.rr) + more};
}

double row_norm(Matrix const& x) {
  return larger(magnitude(x.ee) + magnitude(x.er), magnitude(x.re) + magnitude(x.rr));
}

/// With the norm of A^m at most `norm` < 1, the terms from m on add to an element at most its row's sum times
/// norm + norm^2 + ...
Matrix with_rest(Matrix const& sum, double norm) {
  double const factor = norm / (1 - norm) * outwards;
  double const of_e = (sum.ee + sum.er) * factor;
  double const of_r = (sum.re + sum.rr) * factor;
  return {sum.ee + of_e, sum.er + of_e, sum.re + of_r, sum.rr + of_r};
}

/// Where a walk did not end: doubling m until A^m is small,
///     sum over n < 2m of |A^n|  <=  (sum over n < m of |A^n|) (1 + |A^m|).
Matrix doubled(Matrix sum, Matrix power) {
  constexpr uint32_t most_doublings = 64;
  constexpr double small = 0x1p-4;
  double error = rounding_of_cycle * row_norm(sum) * row_norm(sum);
  for (uint32_t i = 0; i < most_doublings; ++i) {
    Matrix const most = magnitudes(power, error);
    double const norm = row_norm(most);
    if (norm <= small) return with_rest(sum, norm);
    Matrix const added = product(sum, most);
    sum = {sum.ee + added.ee, sum.er + added.er, sum.re + added.re, sum.rr + added.rr};
    error = 2 * norm * error + 4 * unit_roundoff * norm * norm;
    power = product(power, power);
  }
  constexpr double huge = 0x1p200;
  return {huge, huge, huge, huge};
}

/// A power of two s with k/4 < s^2 <= k: scaling with it rounds nothing.
double scale_of(double k) {
  uint64_t const exponent = std::bit_cast<uint64_t>(k) >> 52U;
  return std::bit_cast<double>(((exponent + 1023) / 2) << 52U);
}

}  // namespace

SectionBound bound_section(double p, double q, double k, double b, bool blocks_constant) {
  auto const [g, lost_of_g] = exact_sum(p, q);
  double const s = scale_of(k);
  Walk of_e{.e = 1, .r = 0};
  Walk of_r{.e = 0, .r = 1};
  Walk of_impulse{.e = p, .r = g - k * p - b * p};
  Matrix power{};
  uint32_t cycles = 0;
  do {
    for (uint32_t i = 0; i < cycles_of_walk; ++i) {
      of_e.step(k, b);
      of_r.step(k, b);
      of_impulse.step(k, b);
    }
    cycles += cycles_of_walk;
    power = {of_e.e, of_r.e * s, of_e.r / s, of_r.r};
  } while (row_norm(power) > shrunk && cycles < longest_walk);

  bool const ended = row_norm(power) <= shrunk;
  Matrix const first{of_e.sum_e, of_r.sum_e * s, of_e.sum_r / s, of_r.sum_r};
  Matrix all = ended ? with_rest(first, shrunk_with_rounding) : doubled(first, power);
  // Roundings enter as states do: what they add to the sums is at most 12 u (row of e or r) (column).
  double const row_e = (all.ee + all.er) * rounding_of_cycle;
  double const row_r = (all.re + all.rr) * rounding_of_cycle;
  double const column_e = all.ee + all.re;
  double const column_r = all.er + all.rr;
  bool const is_certain = ended && larger(row_e, row_r) <= most_rounding;
  all = {all.ee + row_e * column_e, all.er + row_e * column_r, all.re + row_r * column_e,
         all.rr + row_r * column_r};

  SectionBound bound{};
  bound.p = p;
  bound.g = g;
  bound.k = k;
  bound.b = b;
  bound.lost_of_g = lost_of_g;
  bound.ee = all.ee * outwards;
  bound.er = all.er / s * outwards;
  bound.re = all.re * s * outwards;
  bound.rr = all.rr * outwards;
  double const left = bound.re * magnitude(of_r.e) + bound.rr * magnitude(of_r.r);
  bound.change = (of_r.change + 2 * (row_r * column_r + left)) * outwards;
  double const left_e = magnitude(of_impulse.e);
  double const left_r = magnitude(of_impulse.r);
  double const walked = of_impulse.sum_e * s + of_impulse.sum_r;
  bound.excess = (of_impulse.sum_e + row_e / s * walked + bound.ee * left_e + bound.er * left_r) * outwards;
  bound.following = (of_impulse.sum_r + row_r * walked + bound.re * left_e + bound.rr * left_r) * outwards;
  bound.passed = (blocks_constant ? magnitude(p) : magnitude(1 + p)) + bound.following;
  bound.shrinking = is_certain ? cycles : 0;
  bound.scale = s;
  bound.radius = smallest_radius(k, b);
  return bound;
}

}  // namespace axisc::runtime::bounds
