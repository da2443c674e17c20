// Units as people write them after a number: "kHz", "mm/min", "ms".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace axisc::validator {

/// True for a word that is a unit: "ms", "[mm/min]", "µm".
[[nodiscard]] bool is_unit(std::string_view word);

/// How many of `unit`, a unit of the catalogue ("0.1 um"), one of `word` is: 1000 for "kHz" and "Hz". None if
/// the one is not the other's.
[[nodiscard]] std::optional<double> unit_ratio(std::string_view word, std::string_view unit);

/// `number` times `ratio` in digits; empty where that has decimals and `is_integer` allows none.
[[nodiscard]] std::string converted_number(double number, double ratio, bool is_integer);

}  // namespace axisc::validator
