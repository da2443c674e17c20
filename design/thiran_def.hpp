// The all-pass of Thiran: magnitude 1 everywhere, group delay maximally flat at 0 Hz and there exactly D
// cycles.
#pragma once

#include "design/polynomial_roots_def.hpp"
#include "design/section_def.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace axisc::design {

/// n = max(1, floor(D + 0.5)): the order for which the delay is most even and the poles are well inside.
template <typename Number>
[[nodiscard]] std::uint32_t thiran_order(Number const& D) {
  using std::floor;
  auto const n = static_cast<std::uint32_t>(static_cast<double>(floor(D + Number(0.5))));
  return n < 1 ? 1 : n;
}

/// a_k = (-1)^k C(n,k) Π_{i=0..n} (D - n + i)/(D - n + k + i), as z^n + a_1 z^(n-1) + ... + a_n.
template <typename Number>
[[nodiscard]] Polynomial<Number> thiran_denominator(Number const& D, std::uint32_t n) {
  Polynomial<Number> a(n + 1);
  Number binomial{1};
  for (std::uint32_t k = 0; k <= n; ++k) {
    Number a_k = k % 2 == 0 ? binomial : Number(-binomial);
    for (std::uint32_t i = 0; i <= n; ++i) a_k *= (D - n + i) / (D - n + k + i);
    a[n - k] = a_k;
    binomial = binomial * (n - k) / (k + 1);
  }
  return a;
}

/// Section with the poles' (1 - z1)(1 - z2) and z1 z2: (a2 + a1 z^-1 + z^-2)/(1 + a1 z^-1 + a2 z^-2), p = q =
/// -b.
template <typename Number>
[[nodiscard]] Section<Number> allpass_section(Number const& k, Number const& product) {
  Number const b = 1 - product;
  return {.p = -b, .q = -b, .k = k, .b = b, .slope = -2 * b / k};
}

template <typename Number>
[[nodiscard]] std::vector<Section<Number>> thiran(Number const& D) {
  std::vector<Section<Number>> sections;
  std::vector<Number> real;
  for (auto const& z : polynomial_roots(thiran_denominator(D, thiran_order(D)))) {
    if (z.im == 0) {
      real.push_back(z.re);
    } else {
      sections.push_back(
          allpass_section<Number>((1 - z.re) * (1 - z.re) + z.im * z.im, square_of_magnitude(z)));
    }
  }
  std::size_t i = 0;
  for (; i + 1 < real.size(); i += 2) {
    sections.push_back(allpass_section<Number>((1 - real[i]) * (1 - real[i + 1]), real[i] * real[i + 1]));
  }
  if (i < real.size()) {  // (a1 + z^-1)/(1 + a1 z^-1)
    Number const p = -(1 + real[i]);
    Number const k = 1 - real[i];
    sections.push_back({.p = p, .q = Number(0), .k = k, .b = Number(1), .slope = p / k});
  }
  return sections;
}

}  // namespace axisc::design
