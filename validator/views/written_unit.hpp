// Units as people write them after a number: "kHz", "mm/min", "ms".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace axisc::validator {

/// The word with which a text begins, without what separates it from the rest: "ms" of "ms; dead time".
/// "min." keeps its point, because it is no unit: it is short for "minimal".
[[nodiscard]] std::string_view unit_word(std::string_view text);

/// True for a word that is a unit: "ms", "[mm/min]", "µm", "KHZ", "mm/sec".
[[nodiscard]] bool is_unit(std::string_view word);

/// How many of `unit`, a unit of the catalogue ("0.1 um"), one of `word` is: 1000 for "kHz" and "Hz". None if
/// the one is not the other's, or may be several ("MHZ").
[[nodiscard]] std::optional<double> unit_ratio(std::string_view word, std::string_view unit);

/// `number` times `ratio` in digits; empty where that has decimals and `is_integer` allows none.
[[nodiscard]] std::string converted_number(double number, double ratio, bool is_integer);

}  // namespace axisc::validator
