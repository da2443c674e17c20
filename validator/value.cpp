#include "validator/value.hpp"

#include "grammar/lexical.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <system_error>

namespace axisc::validator {
namespace {

constexpr char fold(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool equal_folded(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return fold(x) == fold(y); });
}

constexpr bool is_digit(char c) {
  return grammar::is(grammar::character::digit, c);
}

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
  constexpr std::size_t prefix = grammar::lexical::hexadecimal_prefix.size();
  if (digits.text.size() > prefix && grammar::lexical::begins_hexadecimal(digits.text)) {
    digits.base = 16;
    digits.text.remove_prefix(prefix);
  }
  return digits;
}

bool has_leading_zero(Digits const& digits) {
  return digits.base == 10 && grammar::lexical::has_leading_zero(digits.text);
}

struct ExactRange {
  std::int64_t lowest = 0;
  std::uint64_t highest = 0;
};

/// In the order of schema::DataType; reals and strings, which have no such range, hold what 64 bits hold.
constexpr std::array<ExactRange, 11> exact_ranges = [] {
  using Wide = std::numeric_limits<std::int64_t>;
  constexpr ExactRange widest{.lowest = Wide::min(), .highest = static_cast<std::uint64_t>(Wide::max())};
  return std::array<ExactRange, 11>{{{.lowest = 0, .highest = 1},
                                     {.lowest = 0, .highest = std::numeric_limits<std::uint8_t>::max()},
                                     {.lowest = 0, .highest = std::numeric_limits<std::uint16_t>::max()},
                                     {.lowest = 0, .highest = std::numeric_limits<std::uint32_t>::max()},
                                     {.lowest = 0, .highest = std::numeric_limits<std::uint64_t>::max()},
                                     {.lowest = -128, .highest = 127},
                                     {.lowest = -32768, .highest = 32767},
                                     {.lowest = -2147483648LL, .highest = 2147483647},
                                     widest,
                                     widest,
                                     widest}};
}();
static_assert(static_cast<std::size_t>(schema::DataType::boolean) == 0 &&
              static_cast<std::size_t>(schema::DataType::sgn08) == 5 &&
              static_cast<std::size_t>(schema::DataType::string) + 1 == exact_ranges.size());

constexpr std::array<DataRange, exact_ranges.size()> data_ranges = [] {
  std::array<DataRange, exact_ranges.size()> rounded;
  std::transform(exact_ranges.begin(), exact_ranges.end(), rounded.begin(), [](ExactRange const& range) {
    return DataRange{.lowest = static_cast<double>(range.lowest),
                     .highest = static_cast<double>(range.highest)};
  });
  return rounded;
}();

ExactRange const& exact_range(schema::DataType type) {
  return exact_ranges[static_cast<std::size_t>(type)];
}

constexpr std::size_t digits_without_overflow = 19;

/// A decimal number of at most so many digits, as nearly all integers of a list are. None where one is no digit.
std::optional<std::uint64_t> read_decimal_digits(std::string_view digits) {
  std::uint64_t value = 0;
  for (char const digit : digits) {
    if (!is_digit(digit)) return std::nullopt;
    value = value * 10 + static_cast<std::uint64_t>(digit - '0');
  }
  return value;
}

bool fits(std::uint64_t magnitude, bool negative, ExactRange const& range) {
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
  bool const good = !overflow && fits(magnitude, digits.negative, exact_range(type));
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
  if (digits.text.empty() || !(is_digit(digits.text.front()) || digits.text.front() == '.')) return {};
  double value = 0;
  char const* const end = digits.text.data() + digits.text.size();
  auto const [stop, error] = std::from_chars(digits.text.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return {};
  if (error == std::errc::result_out_of_range) {
    // Too small is zero, as everywhere; only a number that is too big cannot be meant.
    std::size_t const exponent = digits.text.find_first_of("eE");
    bool const tiny = exponent != std::string_view::npos && digits.text.substr(exponent + 1, 1) == "-";
    return {.status = tiny ? NumberStatus::good : NumberStatus::exponent_too_big, .number = 0};
  }
  return {.status = NumberStatus::good, .number = digits.negative ? -value : value};
}

bool is_complete_number(std::string_view text) {
  return read_real(text).status == NumberStatus::good;
}

DataRange data_range(schema::DataType type) {
  return data_ranges[static_cast<std::size_t>(type)];
}

SymbolReading read_symbol(schema::Parameter const& parameter, std::string_view word) {
  for (schema::Symbol const& symbol : parameter.symbols) {
    if (symbol.word == word) return {.symbol = &symbol, .folded = false};
  }
  for (schema::Symbol const& symbol : parameter.symbols) {
    if (equal_folded(symbol.word, word)) return {.symbol = &symbol, .folded = true};
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
  constexpr std::string_view prefix = grammar::lexical::reference_prefix;
  std::uint16_t number = 0;
  if (parameter.default_text.substr(0, prefix.size()) != prefix) return 0;
  std::string_view const digits = parameter.default_text.substr(prefix.size());
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

}  // namespace axisc::validator
