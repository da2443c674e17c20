// The sign of a sum of products of doubles, without any rounding: the sum is kept as doubles that do not
// overlap (J. R. Shewchuk, 1997), of which the last one that is not 0 decides.
#pragma once

#include "runtime/twofold.hpp"

#include <stdint.h>

namespace axisc::runtime::bounds {

class ExactSum {
 public:
  /// At most 8 products of numbers whose product is far from under- and overflow.
  constexpr void add_product(double a, double b) {
    Twofold const product = exact_product(a, b);
    add(product.low);
    add(product.high);
  }

  [[nodiscard]] constexpr bool is_negative() const {
    for (uint32_t i = count_; i > 0; --i) {
      if (parts_[i - 1] != 0) return parts_[i - 1] < 0;
    }
    return false;
  }

 private:
  constexpr void add(double value) {
    for (uint32_t i = 0; i < count_; ++i) {
      Twofold const sum = exact_sum(value, parts_[i]);
      parts_[i] = sum.low;
      value = sum.high;
    }
    parts_[count_++] = value;
  }

  double parts_[16] = {};
  uint32_t count_ = 0;
};

}  // namespace axisc::runtime::bounds
