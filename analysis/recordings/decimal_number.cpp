#include "analysis/recordings/decimal_number.hpp"

#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <system_error>

namespace axisc::recordings {

namespace {

constexpr std::size_t longest_number = 400;
/// Quotients of whole numbers up to 2^53 and these are correctly rounded.
constexpr std::array<double, 20> powers_of_ten{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,
                                               1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19};
constexpr std::uint64_t largest_dividend = std::uint64_t{1} << 53U;
constexpr std::size_t most_digits = 18;

DecimalMark mark_of(char byte) {
  return byte == ',' ? DecimalMark::comma : DecimalMark::point;
}

/// Exponents, many digits, inf and nan.
std::optional<DecimalNumber> parse_any(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  std::array<char, longest_number> copy{};
  if (text.size() > copy.size()) return std::nullopt;
  std::copy(text.begin(), text.end(), copy.begin());
  DecimalNumber number;
  auto const mark = text.find_first_of(".,");
  if (mark != std::string_view::npos) {
    number.mark = mark_of(text[mark]);
    copy.at(mark) = '.';
  }
  auto const* const end = copy.data() + text.size();
  auto const [stop, error] = std::from_chars(copy.data(), end, number.value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return number;
}

}  // namespace

std::optional<DecimalNumber> parse_number(std::string_view text) {
  std::size_t at = 0;
  bool const is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) ++at;
  std::size_t const begin = at;
  std::uint64_t digits = 0;
  while (at < text.size() && ascii::is_digit(text[at])) {
    digits = digits * 10 + static_cast<unsigned char>(text[at++] - '0');
  }
  std::size_t count = at - begin;
  std::size_t decimals = 0;
  DecimalMark mark = DecimalMark::none;
  if (count > 0 && at < text.size() && (text[at] == '.' || text[at] == ',')) {
    mark = mark_of(text[at++]);
    std::size_t const first = at;
    while (at < text.size() && ascii::is_digit(text[at])) {
      digits = digits * 10 + static_cast<unsigned char>(text[at++] - '0');
    }
    decimals = at - first;
    count += decimals;
  }
  bool const is_plain = at == text.size() && count > 0 && count <= most_digits && digits <= largest_dividend;
  if (!is_plain) return parse_any(text);
  double const value = static_cast<double>(digits) / powers_of_ten[decimals];
  return DecimalNumber{.value = is_negative ? -value : value, .mark = mark};
}

std::optional<std::uint64_t> parse_whole(std::string_view text) {
  bool const is_hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (is_hexadecimal) text.remove_prefix(2);
  std::uint64_t number = 0;
  auto const [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), number, is_hexadecimal ? 16 : 10);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace axisc::recordings
