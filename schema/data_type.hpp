// Types of parameters as the control's documentation names them, and the numbers of parameters.
#pragma once

#include <array>
#include <cstdint>
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

/// "UNS32".
[[nodiscard]] std::string_view data_type_name(DataType type);
[[nodiscard]] constexpr bool is_integer(DataType type) {
  return type >= DataType::uns08 && type <= DataType::sgn64;
}
/// An integer or a real.
[[nodiscard]] constexpr bool is_number(DataType type) {
  return is_integer(type) || type == DataType::real64;
}

/// In the order of DataType.
inline constexpr std::array<std::string_view, 11> data_type_words = {
    "BOOLEAN", "UNS08", "UNS16", "UNS32", "UNS64", "SGN08", "SGN16", "SGN32", "SGN64", "REAL64", "STRING"};
/// DataType::uns08 of "UNS08".
[[nodiscard]] std::optional<DataType> parse_data_type(std::string_view word);
/// The lowest or highest value of a type of numbers; of 64 bits rounded to double.
[[nodiscard]] double data_type_limit(DataType type, bool highest);
/// True for a number as lists write it that the type can hold: decimal or hexadecimal, no leading zeros.
[[nodiscard]] bool is_number_of_type(std::string_view text, DataType type);

/// "P-AXIS-00140"; empty for 0.
[[nodiscard]] std::string p_axis_text(std::uint16_t number);
/// 140 of "P-AXIS-00140".
[[nodiscard]] std::optional<std::uint16_t> parse_p_axis(std::string_view text);

}  // namespace axisc::schema
