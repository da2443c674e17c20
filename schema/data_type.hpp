// The data types of axis parameters, a row each: their names and ranges. And the numbers of parameters.
#pragma once

#include "schema/list_kind.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace axisc::schema {

enum class DataType : std::uint8_t {
  boolean,
  uns08,
  uns16,
  uns32,
  uns64,
  sgn08,
  sgn16,
  sgn32,
  sgn64,
  real64,
  string
};

/// Both ends belong to it.
struct IntegerRange {
  std::int64_t lowest = 0;
  std::uint64_t highest = 0;
};

template <typename Integer>
inline constexpr IntegerRange range_of_integer{.lowest = std::numeric_limits<Integer>::min(),
                                               .highest = std::numeric_limits<Integer>::max()};

struct DataTypeRow {
  DataType type;
  std::string_view name;
  IntegerRange integers;  ///< for reals and strings, which have no such range, that of 64 bits
};

inline constexpr std::array data_types{
    DataTypeRow{DataType::boolean, "BOOLEAN", {.lowest = 0, .highest = 1}},
    DataTypeRow{DataType::uns08, "UNS08", range_of_integer<std::uint8_t>},
    DataTypeRow{DataType::uns16, "UNS16", range_of_integer<std::uint16_t>},
    DataTypeRow{DataType::uns32, "UNS32", range_of_integer<std::uint32_t>},
    DataTypeRow{DataType::uns64, "UNS64", range_of_integer<std::uint64_t>},
    DataTypeRow{DataType::sgn08, "SGN08", range_of_integer<std::int8_t>},
    DataTypeRow{DataType::sgn16, "SGN16", range_of_integer<std::int16_t>},
    DataTypeRow{DataType::sgn32, "SGN32", range_of_integer<std::int32_t>},
    DataTypeRow{DataType::sgn64, "SGN64", range_of_integer<std::int64_t>},
    DataTypeRow{DataType::real64, "REAL64", range_of_integer<std::int64_t>},
    DataTypeRow{DataType::string, "STRING", range_of_integer<std::int64_t>},
};

[[nodiscard]] constexpr DataTypeRow const& row_of(DataType type) {
  return data_types[static_cast<std::size_t>(type)];
}

static_assert([] {
  for (std::size_t i = 0; i < data_types.size(); ++i) {
    if (static_cast<std::size_t>(data_types[i].type) != i) return false;
  }
  return data_types.size() == static_cast<std::size_t>(DataType::string) + 1;
}());

/// The names, in the order of DataType.
inline constexpr auto data_type_words = [] {
  std::array<std::string_view, data_types.size()> words;
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = data_types[i].name;
  return words;
}();
/// DataType::uns08 of "UNS08".
[[nodiscard]] std::optional<DataType> parse_data_type(std::string_view word);

/// "UNS32".
[[nodiscard]] constexpr std::string_view data_type_name(DataType type) {
  return row_of(type).name;
}
[[nodiscard]] constexpr bool is_integer(DataType type) {
  return type >= DataType::uns08 && type <= DataType::sgn64;
}
/// An integer or a real.
[[nodiscard]] constexpr bool is_number(DataType type) {
  return is_integer(type) || type == DataType::real64;
}

/// Both ends belong to it.
struct DataRange {
  double lowest = 0;
  double highest = 0;
};
/// The range of a number type, as MIN(UNS32) and MAX(UNS32) name it. Exact but for the 64-bit integers, whose
/// limits are rounded to double.
[[nodiscard]] constexpr DataRange data_range(DataType type) {
  using Real = std::numeric_limits<double>;
  if (type == DataType::real64) return {.lowest = Real::lowest(), .highest = Real::max()};
  IntegerRange const& integers = row_of(type).integers;
  return {.lowest = static_cast<double>(integers.lowest), .highest = static_cast<double>(integers.highest)};
}

/// True for a number as lists write it that the type can hold: decimal or hexadecimal, no leading zeros.
[[nodiscard]] bool is_number_of_type(std::string_view text, DataType type);

/// "P-AXIS-00140", "P-CHAN-00035"; empty for 0.
[[nodiscard]] std::string number_text(ListKind kind, std::uint16_t number);
[[nodiscard]] inline std::string p_axis_text(std::uint16_t number) {
  return number_text(ListKind::axis, number);
}
/// 140 of "P-AXIS-00140"; none for the number of another kind.
[[nodiscard]] std::optional<std::uint16_t> parse_number(ListKind kind, std::string_view text);
[[nodiscard]] inline std::optional<std::uint16_t> parse_p_axis(std::string_view text) {
  return parse_number(ListKind::axis, text);
}

}  // namespace axisc::schema
