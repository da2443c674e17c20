// The number π in any type.
#pragma once

#include <limits>
#include <numbers>
#include <type_traits>

namespace axisc::design {

/// 130 decimals are written out. A library's constant would be read from its digits whenever the program
/// starts, also where nothing is designed.
template <typename Number>
[[nodiscard]] Number pi() {
  if constexpr (std::is_floating_point_v<Number>) {
    return std::numbers::pi_v<Number>;
  } else {
    static_assert(std::numeric_limits<Number>::max_digits10 <= 130);
    static Number const value(
        "3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803482534211706"
        "79821480865132823066470938446095");
    return value;
  }
}

}  // namespace axisc::design
