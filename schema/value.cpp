#include "schema/value.hpp"

#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <system_error>

namespace axisc::schema {
namespace {

struct Digits {
  bool negative = false;
  int base = 10;
  std::string_view text;
};

Digits split_integer(std::string_view text) {
  Digits digits{.negative = false, .base = 10, .text = text};
  if (!text.empty() && (text.front() == '+' || text.front() == '-')) {
    digits.negative = text.front() == '-';
    digits.text.remove_prefix(1);
  }
  if (digits.text.size() > 2 && digits.text[0] == '0' && ascii::lower_case(digits.text[1]) == 'x') {
    digits.base = 16;
    digits.text.remove_prefix(2);
  }
  return digits;
}

bool has_leading_zero(Digits const& digits) {
  return digits.base == 10 && ascii::has_leading_zero(digits.text);
}

constexpr std::size_t digits_without_overflow = 19;

/// A decimal number of at most this many digits, as nearly all integers of a list are. None where one is not
/// a digit.
std::optional<std::uint64_t> read_decimal_digits(std::string_view digits) {
  std::uint64_t value = 0;
  for (char const digit : digits) {
    if (!ascii::is_digit(digit)) return std::nullopt;
    value = value * 10 + static_cast<std::uint64_t>(digit - '0');
  }
  return value;
}

bool fits(std::uint64_t magnitude, bool negative, schema::IntegerRange const& range) {
  if (!negative) return magnitude <= range.highest;
  // -lowest as an unsigned number, also for the lowest of all
  std::uint64_t const room = std::uint64_t{0} - static_cast<std::uint64_t>(range.lowest);
  return magnitude <= room;
}

}  // namespace

NumberReading read_integer(std::string_view text, schema::DataType type) {
  Digits const digits = split_integer(text);
  if (has_leading_zero(digits)) return {.status = NumberStatus::leading_zero, .number = 0};
  std::uint64_t magnitude = 0;
  bool overflow = false;
  if (digits.base == 10 && !digits.text.empty() && digits.text.size() <= digits_without_overflow) {
    auto const read = read_decimal_digits(digits.text);
    if (!read) return {};
    magnitude = *read;
  } else {
    char const* const end = digits.text.data() + digits.text.size();
    auto const [stop, error] = std::from_chars(digits.text.data(), end, magnitude, digits.base);
    if (stop != end || error == std::errc::invalid_argument) return {};
    overflow = error != std::errc{};
  }
  bool const good = !overflow && fits(magnitude, digits.negative, schema::row_of(type).integers);
  double const size = overflow ? std::numeric_limits<double>::infinity() : static_cast<double>(magnitude);
  return {.status = good ? NumberStatus::good : NumberStatus::out_of_data_range,
          .number = digits.negative ? -size : size};
}

NumberReading read_real(std::string_view text) {
  Digits const digits = split_integer(text);
  if (digits.base == 16) {
    NumberReading hexadecimal = read_integer(text, schema::DataType::uns64);
    if (hexadecimal.status == NumberStatus::out_of_data_range) {
      hexadecimal.status = NumberStatus::exponent_too_big;
    }
    return hexadecimal;
  }
  if (has_leading_zero(digits)) return {.status = NumberStatus::leading_zero, .number = 0};
  if (digits.text.empty() || !(ascii::is_digit(digits.text.front()) || digits.text.front() == '.')) return {};
  double value = 0;
  char const* const end = digits.text.data() + digits.text.size();
  auto const [stop, error] = std::from_chars(digits.text.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return {};
  if (error == std::errc::result_out_of_range) {
    // A number that is too small is zero, as everywhere; only a number that is too big cannot be meant.
    std::size_t const exponent = digits.text.find_first_of("eE");
    bool const tiny = exponent != std::string_view::npos && digits.text.substr(exponent + 1, 1) == "-";
    return {.status = tiny ? NumberStatus::good : NumberStatus::exponent_too_big, .number = 0};
  }
  return {.status = NumberStatus::good, .number = digits.negative ? -value : value};
}

bool is_complete_number(std::string_view text) {
  return read_real(text).status == NumberStatus::good;
}

SymbolReading read_symbol(schema::Parameter const& parameter, std::string_view word) {
  for (schema::Symbol const& symbol : parameter.symbols) {
    if (symbol.word == word) return {.symbol = &symbol, .folded = false};
  }
  for (schema::Symbol const& symbol : parameter.symbols) {
    if (ascii::equal_ignoring_case(symbol.word, word)) return {.symbol = &symbol, .folded = true};
  }
  return {};
}

schema::Symbol const* symbol_of_number(schema::Parameter const& parameter, double number) {
  for (schema::Symbol const& symbol : parameter.symbols) {
    if (symbol.number && *symbol.number == number) return &symbol;
    std::string_view const word = symbol.word;
    if ((number == 0 && (word == "FALSE" || word == "0")) || (number == 1 && word == "TRUE")) return &symbol;
  }
  return nullptr;
}

Value value_of(schema::Symbol const& symbol) {
  double const number = symbol.number ? *symbol.number : symbol.word == "TRUE" ? 1 : 0;
  return {.number = number, .text = symbol.word};
}

bool is_bit_mask(schema::Parameter const& parameter) {
  if (parameter.is_flags) return true;
  return parameter.is_enumeration() && is_complete_number(parameter.default_text) &&
         std::none_of(parameter.symbols.begin(), parameter.symbols.end(),
                      [&parameter](schema::Symbol const& symbol) {
                        return symbol.number.has_value() || symbol.word == parameter.default_text;
                      });
}

std::optional<Value> default_value(schema::Parameter const& parameter) {
  if (!parameter.has_default) return std::nullopt;
  std::string_view const text = parameter.default_text;
  if (!parameter.symbols.empty()) {
    if (schema::Symbol const* const symbol = read_symbol(parameter, text).symbol) return value_of(*symbol);
  }
  if (parameter.type == schema::DataType::string && !is_bit_mask(parameter)) {
    return Value{.number = 0, .text = text};
  }
  if (!std::isnan(parameter.default_number)) return Value{.number = parameter.default_number, .text = {}};
  // Catalogue defaults such as 0x0001 or 1.000000e+002 are numbers in the same forms as in a list.
  NumberReading const reading = read_real(text);
  if (reading.status != NumberStatus::good) return std::nullopt;
  return Value{.number = reading.number, .text = {}};
}

std::uint16_t default_reference(schema::Parameter const& parameter) {
  constexpr std::string_view prefix = "P-AXIS-";
  std::uint16_t number = 0;
  if (parameter.default_text.substr(0, prefix.size()) != prefix) return 0;
  std::string_view const digits = parameter.default_text.substr(prefix.size());
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

}  // namespace axisc::schema
