// Several message numbers of the control, as a row holds them.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace axisc::validator::checks {

/// Every number with a slash after it.
template <std::string_view const&... numbers>
inline constexpr auto joined_numbers = [] {
  std::array<char, (numbers.size() + ...) + sizeof...(numbers)> joined{};
  joined.fill('/');
  auto* at = joined.data();
  for (std::string_view const number : {numbers...}) at = std::copy(number.begin(), number.end(), at) + 1;
  return joined;
}();

/// control_numbers<refused, clipped>, of constants "50553" and "50911": "50553/50911".
template <std::string_view const&... numbers>
inline constexpr std::string_view control_numbers{joined_numbers<numbers...>.data(),
                                                  joined_numbers<numbers...>.size() - 1};

}  // namespace axisc::validator::checks
