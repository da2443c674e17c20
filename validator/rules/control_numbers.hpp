// Several message numbers of the control, as a row holds them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace axisc::validator::checks {

/// Every number with a slash after it.
template <auto const& numbers>
inline constexpr auto joined_numbers = [] {
  constexpr std::size_t size = [] {
    std::size_t sum = 0;
    for (std::string_view const number : numbers) sum += number.size() + 1;
    return sum;
  }();
  std::array<char, size> joined{};
  joined.fill('/');
  auto* at = joined.data();
  for (std::string_view const number : numbers) at = std::copy(number.begin(), number.end(), at) + 1;
  return joined;
}();

/// "50553/50911", of an array of these two.
template <auto const& numbers>
inline constexpr std::string_view control_text{joined_numbers<numbers>.data(),
                                               joined_numbers<numbers>.size() - 1};

template <std::string_view const&... numbers>
inline constexpr std::array number_list{numbers...};

/// control_numbers<refused, clipped>, of constants "50553" and "50911".
template <std::string_view const&... numbers>
inline constexpr std::string_view control_numbers = control_text<number_list<numbers...>>;

}  // namespace axisc::validator::checks
