// From prototype poles to the sections of low-, high-, all-pass and band filters.
//
// s is normalised to the characteristic frequency; a Discretiser (design/discretisation_def.hpp) turns it
// into sections.
#pragma once

#include "design/discretisation_def.hpp"
#include "design/prototypes_def.hpp"
#include "design/section_def.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace axisc::design {

/// Conjugate pairs become one factor each, real poles two a factor; a last one alone is of first order.
template <typename Number>
[[nodiscard]] std::vector<Denominator<Number>> pair_poles(Poles<Number> const& poles) {
  std::vector<Denominator<Number>> factors;
  std::vector<Number> real;
  for (auto const& p : poles) {
    if (p.im == 0) {
      real.push_back(p.re);
    } else {
      factors.push_back({square_of_magnitude(p), -2 * p.re, Number(1)});
    }
  }
  std::size_t i = 0;
  for (; i + 1 < real.size(); i += 2) {
    factors.push_back({real[i] * real[i + 1], -(real[i] + real[i + 1]), Number(1)});
  }
  if (i < real.size()) factors.push_back({-real[i], Number(1), Number(0), true});
  return factors;
}

/// Π c0/(c0 + c1 s + c2 s²)
template <typename Number>
[[nodiscard]] std::vector<Section<Number>> lowpass(Poles<Number> const& poles,
                                                   Discretiser<Number> const& make) {
  std::vector<Section<Number>> sections;
  for (auto const& c : pair_poles(poles)) sections.push_back(make(c, {-c.c1, -c.c2}));
  return sections;
}

/// The low-pass with s → 1/s: Π c0 s²/(c2 + c1 s + c0 s²)
template <typename Number>
[[nodiscard]] std::vector<Section<Number>> highpass(Poles<Number> const& poles,
                                                    Discretiser<Number> const& make) {
  std::vector<Section<Number>> sections;
  for (auto const& c : pair_poles(poles)) {
    sections.push_back(c.first_order ? make({c.c1, c.c0, Number(0), true}, {c.c0, Number(0)})
                                     : make({c.c2, c.c1, c.c0}, {Number(0), c.c0}));
  }
  return sections;
}

/// Π (c0 - c1 s + c2 s²)/(c0 + c1 s + c2 s²)
template <typename Number>
[[nodiscard]] std::vector<Section<Number>> allpass(Poles<Number> const& poles,
                                                   Discretiser<Number> const& make) {
  std::vector<Section<Number>> sections;
  for (auto const& c : pair_poles(poles)) sections.push_back(make(c, {-2 * c.c1, Number(0)}));
  return sections;
}

/// The band filters' s → Q (s + 1/s) turns a conjugate pair of prototype poles into two of them, s1 and 1/s1
/// with
///     s1² - (p/Q) s1 + 1 = 0
/// The result is the s1 with the larger magnitude; the denominator of the other one is the mirror image.
template <typename Number>
[[nodiscard]] Denominator<Number> split_pair(ComplexNumber<Number> const& p, Number const& Q) {
  using Complex = ComplexNumber<Number>;
  Complex const one{Number(1), Number(0)};
  Complex const half{p.re / (2 * Q), p.im / (2 * Q)};
  Complex const root = square_root((half - one) * (half + one));
  bool const same_direction = half.re * root.re + half.im * root.im >= 0;
  Complex const s1 = same_direction ? half + root : half - root;
  return {square_of_magnitude(s1), -2 * s1.re, Number(1)};
}

template <typename Number>
[[nodiscard]] Denominator<Number> mirrored(Denominator<Number> const& c) {
  return {c.c2, c.c1, c.c0};
}

/// One zero at z = 1 and one at z = -1 a section, gain 1 at s = j of all together. Two sections of one pair
/// have the gain m s/D(s) each, m = |D(j)|, and share it such that both have the same p = m t/sqrt(N1 N2),
/// which never exceeds 1.
template <typename Number>
[[nodiscard]] std::vector<Section<Number>> bandpass(Poles<Number> const& poles, Number const& Q,
                                                    Discretiser<Number> const& make) {
  using std::sqrt;
  std::vector<Section<Number>> sections;
  for (auto const& p : poles) {
    if (p.im == 0) {
      sections.push_back(make({Q, -p.re, Q}, {-p.re, Number(0)}));
      continue;
    }
    Denominator<Number> const c = split_pair(p, Q);
    Denominator<Number> const mirror = mirrored(c);
    Number const detuning = c.c0 - c.c2;
    Number const m = sqrt(detuning * detuning + c.c1 * c.c1);
    Number const balance = sqrt(normaliser(c, make.t) / normaliser(mirror, make.t));
    sections.push_back(make(c, {m * balance, Number(0)}));
    sections.push_back(make(mirror, {m / balance, Number(0)}));
  }
  return sections;
}

/// Zeros at s = ±j in every section, gain 1 at s = 0 in every section. 1/p takes the place of the band-pass'
/// p.
template <typename Number>
[[nodiscard]] std::vector<Section<Number>> bandstop(Poles<Number> const& poles, Number const& Q,
                                                    Discretiser<Number> const& make) {
  std::vector<Section<Number>> sections;
  for (auto const& p : poles) {
    if (p.im == 0) {
      Number const c1 = -1 / p.re;
      sections.push_back(make({Q, c1, Q}, {-c1, Number(0)}));
      continue;
    }
    Number const magnitude = square_of_magnitude(p);
    Denominator<Number> const c = split_pair(ComplexNumber<Number>{p.re / magnitude, p.im / magnitude}, Q);
    Number const detuning = c.c0 - c.c2;
    sections.push_back(make(c, {-c.c1, detuning}));
    sections.push_back(make(mirrored(c), {-c.c1, -detuning}));
  }
  return sections;
}

}  // namespace axisc::design
