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
/// Beyond this a walk says nothing: outwards does not cover the roundings of roundings.
constexpr double hiding = 0x1p-20;
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

/// A power of two s with k/4 < s^2 <= k: scaling with it rounds nothing.
double scale_of(double k) {
  uint64_t const exponent = std::bit_cast<uint64_t>(k) >> 52U;
  return std::bit_cast<double>(((exponent + 1023) / 2) << 52U);
}

/// With the poles v and w, within the radius R, U(n) = sum of v^i w^j over i + j = n - 1 is what e is n
/// cycles after (0, 1). An upper bound of the sum of |U|: 1/k where U >= 0, the same mirrored where its signs
/// alternate; else |U(n)| <= R^(n-1) min(n, 1/sin), with the sine of a complex pole's angle.
double sum_of_powers(double k, double b, double reserve) {
  double const mirrored = (4 - k) - 2 * b;
  double const near = k < mirrored ? k : mirrored;  // of 1 and -1
  double const square = (near + b) * (near + b) / 4;
  double const least = (near - square) - 0x1p-48 * (near + square);  // of the imaginary part's square
  if (least > 0) return 1 / (reserve * larger(reserve, scale_of(least)));
  bool const are_real = (square - near) > 0x1p-48 * (near + square);
  return are_real && b <= 1 ? 1 / near : 1 / (reserve * reserve);
}

/// From the poles alone, for sections whose walk says too little. With |1 - w| <= sqrt(k), true of one pole,
///     e(n) = w^(n-1) + v (1 - w) U(n-1) from (1, 0),   r(n) = -k U(n),
///     e(n) = U(n) from (0, 1),   r(n) = v^n + (w - 1) U(n).
Matrix bound_from_poles(double k, double b, double radius) {
  constexpr double huge = 0x1p200;
  double const reserve = 1 - radius;
  if (!(reserve > 0)) return {huge, huge, huge, huge};
  double const powers = sum_of_powers(k, b, reserve);
  double const root = 2 * scale_of(k);
  double const of_r = (1 / reserve + root * powers) * outwards;
  return {.ee = 1 + of_r, .er = powers * outwards, .re = k * powers * outwards, .rr = of_r};
}

SectionBound from_poles(SectionBound bound, bool blocks_constant) {
  Matrix const all = bound_from_poles(bound.k, bound.b, bound.radius);
  double const p = magnitude(bound.p);
  double const passing = (bound.k + bound.b) * p;
  double const r = magnitude(bound.g - bound.k * bound.p - bound.b * bound.p) +
                   4 * unit_roundoff * (magnitude(bound.g) + passing);
  bound.ee = all.ee;
  bound.er = all.er;
  bound.re = all.re;
  bound.rr = all.rr;
  bound.change = 2 * all.rr;
  bound.excess = all.ee * p + all.er * r;
  bound.following = all.re * p + all.rr * r;
  bound.passed = (blocks_constant ? p : magnitude(1 + bound.p)) + bound.following;
  return bound;
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
  double const radius = smallest_radius(k, b);
  Matrix all = with_rest(first, shrunk_with_rounding);
  if (!ended) {
    Matrix const sums = bound_from_poles(k, b, radius);
    all = {sums.ee, sums.er * s, sums.re / s, sums.rr};
  }
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
  bound.scale = s;
  bound.radius = radius;
  if (larger(row_e, row_r) > hiding) return from_poles(bound, blocks_constant);
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
  return bound;
}

}  // namespace axisc::runtime::bounds
