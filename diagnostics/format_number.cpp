#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace axisc {
namespace {

// Longest text: sign, 17 digits, point, exponent; in plain notation up to 5 zeros more.
using Buffer = std::array<char, 64>;

std::string_view text_in(Buffer const& buffer, std::to_chars_result const& result) {
  return {buffer.data(), static_cast<std::size_t>(result.ptr - buffer.data())};
}

bool reads_better_plain(double value) {
  double const magnitude = std::abs(value);
  return magnitude == 0.0 || (magnitude >= 1e-5 && magnitude < 1e15);
}

std::string without_trailing_zeros(std::string_view text) {
  std::size_t const exponent = std::min(text.find('e'), text.size());
  std::string_view mantissa = text.substr(0, exponent);
  if (mantissa.find('.') != std::string_view::npos) {
    mantissa = mantissa.substr(0, mantissa.find_last_not_of('0') + 1);
    if (mantissa.back() == '.') mantissa.remove_suffix(1);
  }
  if (mantissa == "-0") mantissa.remove_prefix(1);
  return std::string(mantissa).append(text.substr(exponent));
}

}  // namespace

std::string format_exact(double value) {
  Buffer buffer{};
  auto const result = reads_better_plain(value)
                          ? std::to_chars(buffer.begin(), buffer.end(), value, std::chars_format::fixed)
                          : std::to_chars(buffer.begin(), buffer.end(), value);
  return std::string(text_in(buffer, result));
}

Wording exact_number(double value) {
  return Wording::number(format_exact(value));
}

Wording format_rounded(double value, int significant_digits) {
  if (!std::isfinite(value)) return format_exact(value);
  int const digits = std::clamp(significant_digits, 1, 17);
  Buffer buffer{};
  auto result = std::to_chars(buffer.begin(), buffer.end(), value, std::chars_format::scientific, digits - 1);
  if (reads_better_plain(value)) {
    // The exponent is taken after rounding: 9.996 with three digits is 10.
    std::string_view const scientific = text_in(buffer, result);
    std::string_view exponent_text = scientific.substr(scientific.find('e') + 1);
    if (exponent_text.front() == '+') exponent_text.remove_prefix(1);
    int exponent = 0;
    std::from_chars(exponent_text.begin(), exponent_text.end(), exponent);
    int const decimals = std::max(0, digits - 1 - exponent);
    result = std::to_chars(buffer.begin(), buffer.end(), value, std::chars_format::fixed, decimals);
  }
  return Wording::number(without_trailing_zeros(text_in(buffer, result)));
}

Wording format_fixed(double value, int decimals) {
  return Wording::number(fmt::format("{:.{}f}", value, decimals));
}

}  // namespace axisc
