// A number as a double gives it, and what was lost on the way to it: all but the roundings of what was lost.
#pragma once

#include "runtime/twofold.hpp"

namespace axisc::runtime::bounds {

/// Values are those of the same operations in double.
struct Kept {
  double value = 0, lost = 0;

  friend constexpr Kept operator+(Kept a, Kept b) {
    Twofold const sum = exact_sum(a.value, b.value);
    return {.value = sum.high, .lost = (a.lost + b.lost) + sum.low};
  }
  friend constexpr Kept operator-(Kept a, Kept b) { return a + Kept{.value = -b.value, .lost = -b.lost}; }
  friend constexpr Kept operator*(Kept a, Kept b) {
    Twofold const product = exact_product(a.value, b.value);
    return {.value = product.high, .lost = (a.value * b.lost + a.lost * b.value) + product.low};
  }
};

}  // namespace axisc::runtime::bounds
