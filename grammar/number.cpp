#include "grammar/number.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>

namespace axisc::grammar {
namespace {

bool is_digit(char byte) {
  return byte >= '0' && byte <= '9';
}

/// Cuts off a sign; true for minus.
bool take_sign(std::string_view& token) {
  if (token.empty() || (token.front() != '+' && token.front() != '-')) return false;
  bool const negative = token.front() == '-';
  token.remove_prefix(1);
  return negative;
}

/// Exponent of ten of the first digit that is not zero; none when all are zero. Saturates far outside of a
/// double.
std::optional<std::int64_t> decimal_magnitude(std::string_view unsigned_token) {
  constexpr std::int64_t far_outside = 1'000'000'000'000;
  std::size_t const exponent_at = std::min(unsigned_token.find_first_of("eE"), unsigned_token.size());
  std::string_view const mantissa = unsigned_token.substr(0, exponent_at);
  std::size_t const first_digit = mantissa.find_first_not_of("0.");
  if (first_digit == std::string_view::npos) return std::nullopt;
  std::size_t const point = std::min(mantissa.find('.'), mantissa.size());
  auto magnitude = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first_digit);

  std::string_view exponent = unsigned_token.substr(exponent_at);
  if (exponent.empty()) return magnitude;
  exponent.remove_prefix(1);
  bool const negative = take_sign(exponent);
  std::int64_t value = 0;
  for (char const byte : exponent) value = std::min(value * 10 + (byte - '0'), far_outside);
  return magnitude + (negative ? -value : value);
}

}  // namespace

std::optional<double> real_value(std::string_view token) {
  bool const negative = take_sign(token);
  // from_chars reads a sign, infinities and NaN as well.
  if (token.empty() || (!is_digit(token.front()) && token.front() != '.')) return std::nullopt;
  double value = 0;
  char const* const end = token.data() + token.size();
  auto const [stop, error] = std::from_chars(token.data(), end, value);
  if (error == std::errc::result_out_of_range) {
    auto const magnitude = decimal_magnitude(token);
    if (magnitude && *magnitude > 0) return std::nullopt;
    value = 0;
  } else if (error != std::errc{} || stop != end) {
    return std::nullopt;
  }
  return negative ? -value : value;
}

}  // namespace axisc::grammar
