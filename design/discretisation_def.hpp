// From a section of an analogue filter to one of the digital filter.
//
// s is normalised to the characteristic frequency f. With w = 1 - z^-1 it becomes
//     bilinear transform   (1/t) w/(2 - w)      t = tan(π f T), or π f T without pre-warping
//     backward Euler       w/(2t)               t = π f T, as for all that follow
//     forward Euler        w/(2t (1 - w))
// or each pole and zero s becomes z = exp(2 t s).
#pragma once

#include "design/readings.hpp"
#include "design/section_def.hpp"

#include <array>
#include <cmath>

namespace axisc::design {

/// Denominator c0 + c1 s + c2 s² of a section; first order where c2 = 0.
template <typename Number>
struct Denominator {
  Number c0{0};
  Number c1{0};
  Number c2{0};
  bool first_order = false;
};

/// The numerator without the constant part: that of H - 1, or of an H that blocks it.
template <typename Number>
struct Numerator {
  Number n1{0};
  Number n2{0};
};

/// Numerator w (n0 + n1 w) and denominator d0 + d1 w + d2 w² in w = 1 - z^-1, divided by the denominator's
/// value at w = 1.
template <typename Number>
struct Increments {
  Number n0{0}, n1{0};
  Number d0{0}, d1{0}, d2{0};

  [[nodiscard]] Section<Number> section() const {
    Number const N = d0 + d1 + d2;
    return {.p = (n0 + n1) / N, .q = -n1 / N, .k = d0 / N, .b = (d0 + d1) / N, .slope = n0 / d0};
  }
};

/// Value at w = 1 of the denominator of the bilinear transform, by which it divides a section's coefficients.
template <typename Number>
[[nodiscard]] Number normaliser(Denominator<Number> const& c, Number const& t) {
  return c.first_order ? Number(c.c0 * t + c.c1) : Number(c.c0 * t * t + c.c1 * t + c.c2);
}

/// (n1 s + n2 s²)/(c0 + c1 s + c2 s²), discretised by the bilinear transform:
///     numerator    w (2 n1 t + (n2 - n1 t) w)
///     denominator  4 c0 t² + (2 c1 t - 4 c0 t²) w + (c0 t² - c1 t + c2) w²
/// and both are divided by N. No coefficient of the denominator is a difference.
template <typename Number>
[[nodiscard]] Section<Number> bilinear(Denominator<Number> const& c, Numerator<Number> const& n,
                                       Number const& t) {
  Number const slope = n.n1 / (2 * c.c0 * t);
  Number const N = normaliser(c, t);
  if (c.first_order) {
    return {.p = n.n1 / N, .q = Number(0), .k = 2 * c.c0 * t / N, .b = Number(1), .slope = slope};
  }
  return {.p = (n.n1 * t + n.n2) / N,
          .q = (n.n1 * t - n.n2) / N,
          .k = 4 * c.c0 * t * t / N,
          .b = 2 * c.c1 * t / N,
          .slope = slope};
}

template <typename Number>
[[nodiscard]] Section<Number> backward_euler(Denominator<Number> const& c, Numerator<Number> const& n,
                                             Number const& t) {
  Number const u = 2 * t;
  if (c.first_order) return Increments<Number>{.n0 = n.n1, .d0 = u * c.c0, .d1 = c.c1}.section();
  return Increments<Number>{.n0 = u * n.n1, .n1 = n.n2, .d0 = u * u * c.c0, .d1 = u * c.c1, .d2 = c.c2}
      .section();
}

template <typename Number>
[[nodiscard]] Section<Number> forward_euler(Denominator<Number> const& c, Numerator<Number> const& n,
                                            Number const& t) {
  Number const u = 2 * t;
  Number const square = u * u * c.c0;
  if (c.first_order) return Increments<Number>{.n0 = n.n1, .d0 = u * c.c0, .d1 = c.c1 - u * c.c0}.section();
  return Increments<Number>{.n0 = u * n.n1,
                            .n1 = n.n2 - u * n.n1,
                            .d0 = square,
                            .d1 = u * c.c1 - 2 * square,
                            .d2 = square - u * c.c1 + c.c2}
      .section();
}

/// Coefficients of z^0, z^-1, z^-2 of the polynomial with a root z = exp(u s) for each root s of a0 + a1 s +
/// a2 s², and `at_infinity` roots at -1.
template <typename Number>
[[nodiscard]] std::array<Number, 3> matched_roots(std::array<Number, 3> const& a, Number const& u,
                                                  int at_infinity) {
  using std::cos;
  using std::exp;
  using std::sqrt;
  if (a[2] == 0) {
    Number const z = a[1] == 0 ? Number(0) : Number(exp(-a[0] / a[1] * u));
    std::array<Number, 3> made{Number(1), Number(-z), Number(0)};
    for (int i = 0; i < at_infinity; ++i) made = {Number(1), Number(made[1] + 1), Number(made[2] + made[1])};
    return made;
  }
  Number const middle = -a[1] / (2 * a[2]);
  Number const discriminant = middle * middle - a[0] / a[2];
  Number const radius = exp(middle * u);
  if (discriminant < 0) {
    Number const angle = sqrt(Number(-discriminant)) * u;
    return {Number(1), Number(-2 * radius * cos(angle)), Number(radius * radius)};
  }
  Number const apart = exp(sqrt(discriminant) * u);
  return {Number(1), Number(-radius * (apart + 1 / apart)), Number(radius * radius)};
}

/// Where the constant part passes: H = (c0 + (c1 + n1) s + (c2 + n2) s²)/(c0 + c1 s + c2 s²).
template <typename Number>
[[nodiscard]] Section<Number> matched(Denominator<Number> const& c, Numerator<Number> const& n,
                                      Number const& t, bool keeps_infinite) {
  Number const u = 2 * t;
  std::array<Number, 3> const zeros{c.c0, Number(c.c1 + n.n1), Number(c.c2 + n.n2)};
  int const order = c.first_order ? 1 : 2;
  int const degree = zeros[2] != 0 ? 2 : (zeros[1] != 0 ? 1 : 0);
  auto numerator = matched_roots(zeros, u, keeps_infinite ? order - degree : 0);
  auto const denominator = matched_roots<Number>({c.c0, c.c1, c.c2}, u, 0);
  Number const k = denominator[0] + denominator[1] + denominator[2];
  Number const gain = k / (numerator[0] + numerator[1] + numerator[2]);
  Number const p = gain * numerator[0] - 1;
  Number const q = c.first_order ? Number(0) : Number(p + gain * numerator[1] - denominator[1]);
  return {.p = p, .q = q, .k = k, .b = 1 - denominator[2], .slope = (p + q) / k};
}

template <typename Number>
struct Discretiser {
  Number t{0};
  Discretisation method = Discretisation::bilinear;

  [[nodiscard]] Section<Number> operator()(Denominator<Number> const& c, Numerator<Number> const& n) const {
    switch (method) {
      case Discretisation::backward_euler: return backward_euler(c, n, t);
      case Discretisation::forward_euler: return forward_euler(c, n, t);
      case Discretisation::matched: return matched(c, n, t, true);
      case Discretisation::matched_poles: return matched(c, n, t, false);
      case Discretisation::bilinear: break;
    }
    return bilinear(c, n, t);
  }
};

}  // namespace axisc::design
