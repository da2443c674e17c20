#include "schema/data_type.hpp"

#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
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

}  // namespace

std::optional<DataType> parse_data_type(std::string_view word) {
  auto const* const found = std::find(data_type_words.begin(), data_type_words.end(), word);
  if (found == data_type_words.end()) return std::nullopt;
  return static_cast<DataType>(found - data_type_words.begin());
}

bool is_number_of_type(std::string_view text, DataType type) {
  bool const negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (ascii::has_leading_zero(text)) return false;
  bool const hexadecimal = text.size() > 2 && (text.starts_with("0x") || text.starts_with("0X"));
  if (type == DataType::real64 && !hexadecimal) {
    double number = 0;
    return !text.empty() && (ascii::is_digit(text[0]) || text[0] == '.') && read_whole(text, number);
  }
  std::uint64_t magnitude = 0;
  if (!read_whole(hexadecimal ? text.substr(2) : text, magnitude, hexadecimal ? 16 : 10)) return false;
  if (type == DataType::real64) return true;
  IntegerRange const& range = row_of(type).integers;
  if (!negative) return magnitude <= range.highest;
  return magnitude <= 0 - static_cast<std::uint64_t>(range.lowest);
}

std::string number_text(ListKind kind, std::uint16_t number) {
  if (number == 0) return {};
  std::string text = "P-";
  text.append(row_of(kind).family).append("-00000");
  for (std::size_t at = text.size(); number != 0; number /= 10) {
    text[--at] = static_cast<char>('0' + number % 10);
  }
  return text;
}

std::optional<std::uint16_t> parse_number(ListKind kind, std::string_view text) {
  constexpr std::size_t digits = 5;
  if (text.size() < digits) return std::nullopt;
  std::uint16_t number = 0;
  bool const is_one = read_whole(text.substr(text.size() - digits), number) && number != 0;
  if (!is_one || text != number_text(kind, number)) return std::nullopt;
  return number;
}

}  // namespace axisc::schema
