// A parameter's value with its type resolved, and the conversion from the text of a list.
#pragma once

#include "schema/catalogue.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace axisc::schema {

/// Numbers of every kind, booleans and numbered symbols carry `number`; words and strings carry `text` as
/// well. Integers are exact up to 2^53, which every parameter but one (an UNS64 counter) stays below.
struct Value {
  double number = 0;
  /// String, or the word of a symbol (also when the list wrote its number): UTF-8 that the catalogue, the
  /// source or the readings of the list own.
  std::string_view text;

  [[nodiscard]] bool flag() const { return number != 0; }
};

enum class NumberStatus : std::uint8_t {
  good,
  not_a_number,
  leading_zero,       ///< 007: illegal for the control
  exponent_too_big,   ///< 1e999
  out_of_data_range,  ///< an integer that does not fit the data type
};

struct NumberReading {
  NumberStatus status = NumberStatus::not_a_number;
  double number = 0;
};

/// A decimal or hexadecimal integer for the integer type `type`.
[[nodiscard]] NumberReading read_integer(std::string_view text, schema::DataType type);
/// A real, correctly rounded: the nearest double. Integers, decimal or hexadecimal, are reals too.
[[nodiscard]] NumberReading read_real(std::string_view text);
/// True where the whole of `text` is one integer or real, as a second value after the first would be.
[[nodiscard]] bool is_complete_number(std::string_view text);

/// `open`: the limit itself is not allowed.
[[nodiscard]] inline bool violates_minimum(double value, double limit, bool open) {
  return open ? value <= limit : value < limit;
}
[[nodiscard]] inline bool violates_maximum(double value, double limit, bool open) {
  return open ? value >= limit : value > limit;
}
/// Below the minimum or above the maximum where those are numbers, also where the value is allowed
/// nevertheless, as the default is.
[[nodiscard]] inline bool is_outside(schema::Parameter const& parameter, double value) {
  using Kind = schema::Limit::Kind;
  schema::Limit const& low = parameter.minimum;
  schema::Limit const& high = parameter.maximum;
  // Computed without branches: the kinds of limits differ from line to line.
  bool const below = static_cast<bool>((low.kind == Kind::number) &
                                       ((value < low.number) | (low.open & (value == low.number))));
  bool const above = static_cast<bool>((high.kind == Kind::number) &
                                       ((value > high.number) | (high.open & (value == high.number))));
  return below | above;
}

struct SymbolReading {
  schema::Symbol const* symbol = nullptr;  ///< null where no word fits
  bool folded = false;                     ///< fits only after case folding
};
/// A word among the symbols of a boolean or an enumeration.
[[nodiscard]] SymbolReading read_symbol(schema::Parameter const& parameter, std::string_view word);
/// A number among the symbols; null where none has it. `0` and `1` also mean FALSE and TRUE.
[[nodiscard]] schema::Symbol const* symbol_of_number(schema::Parameter const& parameter, double number);
[[nodiscard]] Value value_of(schema::Symbol const& symbol);

/// True for the few enumerations whose words are bits of a mask: their documented default is a number, their
/// words have none. They accept any number and words joined by `|`.
[[nodiscard]] bool is_bit_mask(schema::Parameter const& parameter);

/// The documented default; none where the catalogue has none, or where it is not a plain value.
[[nodiscard]] std::optional<Value> default_value(schema::Parameter const& parameter);
/// The number in a default of the form `P-AXIS-00008`; 0 for every other default.
[[nodiscard]] std::uint16_t default_reference(schema::Parameter const& parameter);

}  // namespace axisc::schema
