// Sums and products of doubles without loss: the rounded result, and its rounding error. Without fused
// multiply-add; both hold for round to nearest and results far from overflow (T. J. Dekker, 1971; D. E.
// Knuth).
#pragma once

namespace axisc::runtime {

/// high + low, where high is the sum rounded to a double.
struct Twofold {
  double high, low;
};

[[nodiscard]] constexpr Twofold exact_sum(double a, double b) {
  double const high = a + b;
  double const b_part = high - a;
  double const a_part = high - b_part;
  return {.high = high, .low = (a - a_part) + (b - b_part)};
}

/// Upper and lower half of the digits.
[[nodiscard]] constexpr Twofold split(double a) {
  constexpr double shift = 0x1p27 + 1;
  double const shifted = shift * a;
  double const high = shifted - (shifted - a);
  return {.high = high, .low = a - high};
}

[[nodiscard]] constexpr Twofold exact_product(double a, double b) {
  double const high = a * b;
  Twofold const a_half = split(a);
  Twofold const b_half = split(b);
  double const crossed =
      (a_half.high * b_half.high - high) + a_half.high * b_half.low + a_half.low * b_half.high;
  return {.high = high, .low = crossed + a_half.low * b_half.low};
}

}  // namespace axisc::runtime
