// Poles of the analogue low-pass prototypes, normalised to |H(j)|² = 1/2 (-3.0103 dB) at s = j:
//     H(s) = Π -p_i / Π (s - p_i)
#pragma once

#include "design/complex_number.hpp"
#include "design/filter_specification.hpp"
#include "design/pi_def.hpp"
#include "design/polynomial_roots_def.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace axisc::design {

/// Real poles have im = 0 and are listed one by one; of a conjugate pair only the pole with im > 0 is listed.
template <typename Number>
using Poles = std::vector<ComplexNumber<Number>>;

/// n equal real poles: (1 + 1/p²)^n = 2 at s = j, p = -1/sqrt(2^(1/n) - 1).
template <typename Number>
[[nodiscard]] Poles<Number> critical_damping_poles(std::uint32_t n) {
  using std::pow;
  using std::sqrt;
  Number const p = -1 / sqrt(pow(Number(2), Number(1) / n) - 1);
  return Poles<Number>(n, {p, Number(0)});
}

/// Equally spaced on the left half of the unit circle: p = -sin φ + j cos φ, φ = (2i + 1) π / 2n.
template <typename Number>
[[nodiscard]] Poles<Number> butterworth_poles(std::uint32_t n) {
  using std::cos;
  using std::sin;
  Poles<Number> poles;
  for (std::uint32_t i = 0; i < n / 2; ++i) {
    Number const angle = pi<Number>() * (2 * i + 1) / (2 * n);
    poles.push_back({-sin(angle), cos(angle)});
  }
  if (n % 2 == 1) poles.push_back({Number(-1), Number(0)});
  return poles;
}

/// θ_n(s) = Σ a_k s^k, a_k = (2n - k)! / (2^(n-k) k! (n - k)!), a_n = 1, a_k = a_(k+1) (k + 1)(2n - k) / (2
/// (n - k)). Exact for the orders of the control.
template <typename Number>
[[nodiscard]] Polynomial<Number> reverse_bessel_polynomial(std::uint64_t n) {
  std::vector<std::uint64_t> a(n + 1, 1);
  for (std::uint64_t k = n; k-- > 0;) a[k] = a[k + 1] * (k + 1) * (2 * n - k) / (2 * (n - k));
  return {a.begin(), a.end()};
}

/// ω with |θ(jω)|² = 2 θ(0)². In x = ω² the left side is a polynomial with positive coefficients, hence
/// convex: Newton's iteration from above falls monotonically onto the root.
template <typename Number>
[[nodiscard]] Number bessel_half_power_frequency(Polynomial<Number> const& theta) {
  using std::sqrt;
  // θ(jω) = even(x) + jω odd(x)
  Polynomial<Number> even, odd;
  for (std::size_t k = 0; k < theta.size(); ++k) {
    Number const signed_coefficient = k % 4 < 2 ? theta[k] : Number(-theta[k]);
    (k % 2 == 0 ? even : odd).push_back(signed_coefficient);
  }
  Number const target = 2 * theta[0] * theta[0];
  Number x = 9;  // above the root for every n up to 6
  for (int iteration = 0; iteration < 40; ++iteration) {
    Number e, de, o, d_o;
    evaluate(even, x, e, de);
    evaluate(odd, x, o, d_o);
    Number const step = (e * e + x * o * o - target) / (2 * e * de + o * o + 2 * x * o * d_o);
    if (step <= 0) break;
    x -= step;
  }
  return sqrt(x);
}

/// Roots of the reverse Bessel polynomial, normalised by magnitude.
template <typename Number>
[[nodiscard]] Poles<Number> bessel_poles(std::uint32_t n) {
  Polynomial<Number> const theta = reverse_bessel_polynomial<Number>(n);
  Number const frequency = bessel_half_power_frequency(theta);
  Poles<Number> poles = polynomial_roots(theta);
  for (auto& p : poles) p = {p.re / frequency, p.im / frequency};
  return poles;
}

template <typename Number>
[[nodiscard]] Poles<Number> prototype_poles(Prototype prototype, std::uint32_t order) {
  switch (prototype) {
    case Prototype::butterworth: return butterworth_poles<Number>(order);
    case Prototype::bessel: return bessel_poles<Number>(order);
    case Prototype::critical_damping: break;
  }
  return critical_damping_poles<Number>(order);
}

}  // namespace axisc::design
