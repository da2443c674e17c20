// Floating point with 113 bits of mantissa, and what the designs of these tests need of it.
#pragma once

#include <cfloat>

namespace axisc::test {

#if LDBL_MANT_DIG == 113
using Quad = long double;
#else
__extension__ using Quad = __float128;
#endif

/// To 113 bits, as a sum of doubles.
inline constexpr Quad quad_pi = static_cast<Quad>(0x1.921fb54442d18p+1) +
                                static_cast<Quad>(0x1.1a62633145c07p-53) +
                                static_cast<Quad>(-0x1.f1976b7ed8fbcp-109);

[[nodiscard]] constexpr Quad absolute(Quad x) {
  return x < 0 ? -x : x;
}

/// Taylor series; expects |x| <= 4.
[[nodiscard]] constexpr Quad sine(Quad x) {
  Quad term = x;
  Quad sum = x;
  for (int n = 1; n < 40; ++n) {
    term *= -x * x / static_cast<Quad>((2 * n) * (2 * n + 1));
    sum += term;
  }
  return sum;
}
[[nodiscard]] constexpr Quad cosine(Quad x) {
  Quad term = 1;
  Quad sum = 1;
  for (int n = 1; n < 40; ++n) {
    term *= -x * x / static_cast<Quad>((2 * n - 1) * (2 * n));
    sum += term;
  }
  return sum;
}
[[nodiscard]] constexpr Quad tangent(Quad x) {
  return sine(x) / cosine(x);
}

/// Newton's iteration; expects x >= 0 of moderate size.
[[nodiscard]] constexpr Quad square_root(Quad x) {
  if (x <= 0) return 0;
  Quad root = x > 1 ? x : Quad{1};
  for (int i = 0; i < 200; ++i) root = (root + x / root) / 2;
  return root;
}

struct QuadComplex {
  Quad re = 0, im = 0;
};
[[nodiscard]] constexpr QuadComplex operator*(QuadComplex a, QuadComplex b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
[[nodiscard]] constexpr Quad squared_magnitude(QuadComplex a) {
  return a.re * a.re + a.im * a.im;
}
[[nodiscard]] constexpr QuadComplex inverse(QuadComplex a) {
  return {a.re / squared_magnitude(a), -a.im / squared_magnitude(a)};
}
[[nodiscard]] constexpr QuadComplex square_root(QuadComplex a) {
  Quad const magnitude = square_root(squared_magnitude(a));
  Quad const re = square_root((magnitude + a.re) / 2);
  Quad const im = square_root((magnitude - a.re) / 2);
  return {re, a.im < 0 ? -im : im};
}

}  // namespace axisc::test
