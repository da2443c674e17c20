// Values of a parameter that are beyond doubt, as nearly every line of nearly every list has them. All others
// are looked at more closely (validator/values/line_value.hpp), and may be right as well.
#pragma once

#include "schema/catalogue.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>

namespace axisc::schema {

enum class PlainKind : std::uint8_t {
  none,     ///< every value has to be looked at
  integer,  ///< from `lowest` to `highest`
  real,     ///< the same; integers are reals too
  boolean,  ///< 0, 1, and `words`, of which the first two are FALSE and TRUE
  symbol,   ///< one of `words`
  text,     ///< a word of at most `longest` bytes
};

/// The plain values of one row of the catalogue. Half a cache line, so that look-ups read contiguous memory.
struct PlainValues {
  double lowest = 0;
  double highest = 0;
  Symbol const* symbols = nullptr;
  std::uint16_t longest = 0;
  std::uint8_t symbol_count = 0;
  PlainKind kind = PlainKind::none;

  [[nodiscard]] constexpr std::span<Symbol const> words() const { return {symbols, symbol_count}; }
};
static_assert(sizeof(PlainValues) <= 32);

namespace detail {

/// The next double above; `value` is finite.
constexpr double next_above(double value) {
  if (value == 0) return std::numeric_limits<double>::denorm_min();
  auto const bits = std::bit_cast<std::uint64_t>(value);
  return std::bit_cast<double>(value > 0 ? bits + 1 : bits - 1);
}

/// The range of the numbers that doubles hold exactly.
constexpr DataRange plain_range_of(DataType type) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  constexpr double exact = 9007199254740992;  // 2^53: doubles hold all integers up to here
  if (!is_integer(type)) return {.lowest = -infinite, .highest = infinite};
  DataRange const range = data_range(type);
  return {.lowest = std::max(range.lowest, -exact), .highest = std::min(range.highest, exact)};
}

// The functions below accept less than the closer look (schema/value.hpp): in doubt, no value is plain.

/// Words with the numbers that they mean, or none; there are not too many.
constexpr bool has_plain_symbols(Parameter const& parameter) {
  bool const any_too_long =
      std::any_of(parameter.symbols.begin(), parameter.symbols.end(), [&parameter](Symbol const& symbol) {
        bool const is_too_long = parameter.max_length != 0 && symbol.word.size() > parameter.max_length;
        return is_too_long || (symbol.word == "TRUE" && !symbol.number);
      });
  return !any_too_long && parameter.symbols.size() < std::numeric_limits<std::uint8_t>::max();
}

/// Words without numbers, and a default that is none of them: they may be bits of a mask, which can be
/// joined.
constexpr bool may_be_bit_mask(Parameter const& parameter) {
  return std::none_of(parameter.symbols.begin(), parameter.symbols.end(), [&parameter](Symbol const& symbol) {
    return symbol.number.has_value() || symbol.word == parameter.default_text;
  });
}

constexpr PlainKind plain_kind_of(Parameter const& parameter) {
  bool const has_limits =
      parameter.minimum.kind == Limit::Kind::number || parameter.maximum.kind == Limit::Kind::number;
  if (parameter.type == DataType::boolean) {
    bool const has_truth_values = parameter.symbols.size() >= 2 && parameter.symbols[0].word == "FALSE" &&
                                  parameter.symbols[1].word == "TRUE";
    return has_truth_values && !has_limits && has_plain_symbols(parameter) ? PlainKind::boolean
                                                                           : PlainKind::none;
  }
  if (parameter.is_enumeration()) {
    bool const is_plain = !has_limits && has_plain_symbols(parameter) && !may_be_bit_mask(parameter);
    return is_plain ? PlainKind::symbol : PlainKind::none;
  }
  if (is_listed_only(parameter)) return PlainKind::none;
  if (parameter.type == DataType::string) return has_limits ? PlainKind::none : PlainKind::text;
  return parameter.type == DataType::real64 ? PlainKind::real : PlainKind::integer;
}

}  // namespace detail

constexpr PlainValues plain_values_of(Parameter const& parameter) {
  DataRange range = detail::plain_range_of(parameter.type);
  Limit const& minimum = parameter.minimum;
  Limit const& maximum = parameter.maximum;
  if (minimum.kind == Limit::Kind::number) {
    range.lowest = std::max(range.lowest, minimum.open ? detail::next_above(minimum.number) : minimum.number);
  }
  if (maximum.kind == Limit::Kind::number) {
    range.highest =
        std::min(range.highest, maximum.open ? -detail::next_above(-maximum.number) : maximum.number);
  }
  PlainValues plain{.lowest = range.lowest, .highest = range.highest};
  plain.kind = detail::plain_kind_of(parameter);
  if (plain.kind == PlainKind::boolean || plain.kind == PlainKind::symbol) {
    plain.symbols = parameter.symbols.data();
    plain.symbol_count = static_cast<std::uint8_t>(parameter.symbols.size());
  }
  if (plain.kind == PlainKind::text) {
    plain.longest =
        parameter.max_length != 0 ? parameter.max_length : std::numeric_limits<std::uint16_t>::max();
  }
  return plain;
}

}  // namespace axisc::schema
