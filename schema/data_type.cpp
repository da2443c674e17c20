#include "schema/data_type.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <system_error>

namespace axisc::schema {
namespace {

/// A number without its sign; true where it was read to its end.
template <typename Number, typename... Format>
bool read_whole(std::string_view text, Number& number, Format... format) {
  char const* const end = text.data() + text.size();
  auto const [stop, error] = std::from_chars(text.data(), end, number, format...);
  return error == std::errc{} && stop == end;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_signed(DataType type) {
  return type >= DataType::sgn08;
}

/// Of an integer, without its sign.
int bits_of(DataType type) {
  auto const size =
      static_cast<int>(type) - static_cast<int>(is_signed(type) ? DataType::sgn08 : DataType::uns08);
  return (8 << size) - (is_signed(type) ? 1 : 0);
}

}  // namespace

std::string_view data_type_name(DataType type) {
  return data_type_words.at(static_cast<std::size_t>(type));
}

std::optional<DataType> parse_data_type(std::string_view word) {
  auto const* const found = std::find(data_type_words.begin(), data_type_words.end(), word);
  if (found == data_type_words.end()) return std::nullopt;
  return static_cast<DataType>(found - data_type_words.begin());
}

double data_type_limit(DataType type, bool highest) {
  if (type == DataType::real64) {
    using Limits = std::numeric_limits<double>;
    return highest ? Limits::max() : Limits::lowest();
  }
  double const power = std::ldexp(1.0, bits_of(type));
  return highest ? power - 1 : is_signed(type) ? -power : 0.0;
}

bool is_number_of_type(std::string_view text, DataType type) {
  bool const negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (text.size() > 1 && text[0] == '0' && is_digit(text[1])) return false;
  bool const hexadecimal = text.size() > 2 && (text.starts_with("0x") || text.starts_with("0X"));
  if (type == DataType::real64 && !hexadecimal) {
    double number = 0;
    return !text.empty() && (is_digit(text[0]) || text[0] == '.') && read_whole(text, number);
  }
  std::uint64_t magnitude = 0;
  if (!read_whole(hexadecimal ? text.substr(2) : text, magnitude, hexadecimal ? 16 : 10)) return false;
  if (type == DataType::real64) return true;
  std::uint64_t const highest = std::numeric_limits<std::uint64_t>::max() >> (64 - bits_of(type));
  if (!negative) return magnitude <= highest;
  return magnitude <= (is_signed(type) ? highest + 1 : 0);
}

std::string p_axis_text(std::uint16_t number) {
  if (number == 0) return {};
  std::string text = "P-AXIS-00000";
  for (std::size_t at = text.size(); number != 0; number /= 10) {
    text[--at] = static_cast<char>('0' + number % 10);
  }
  return text;
}

std::optional<std::uint16_t> parse_p_axis(std::string_view text) {
  constexpr std::string_view prefix = "P-AXIS-";
  constexpr std::size_t digits = 5;
  if (!text.starts_with(prefix) || text.size() != prefix.size() + digits) return std::nullopt;
  std::uint16_t number = 0;
  if (!read_whole(text.substr(prefix.size()), number) || number == 0) return std::nullopt;
  return number;
}

}  // namespace axisc::schema
