// Rows of a catalogue in JSON: those of axis-parameters.json and other-lists.json, which the generator reads,
// and those of schema files.
#pragma once

#include "schema/parameter_row.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace axisc::schema {

enum class RowContradiction : std::uint8_t {
  type_missing,     ///< a new row needs one
  array_sizes,      ///< not one for each [] of the name
  limits_of_words,  ///< limits of a type that has no numbers
  minimum_above_maximum,
  symbols_of_numbers,   ///< symbols of a type that has no words
  symbol_twice,         ///< FALSE or TRUE of a boolean
  length_of_numbers,    ///< max_length of a type that is not a string
  default_not_a_value,  ///< of the type, or of the symbols
};

struct RowProblem {
  RowContradiction what{};
  std::string_view key;  ///< whose value is wrong; the row may lack it
  std::string value;     ///< symbol_twice, default_not_a_value
};

/// A parameter that a limit or a default names by its number; it may be in a later row.
struct NamedParameter {
  std::string_view key;
  std::uint16_t p_axis = 0;
};

struct RowReading {
  ParameterRow row;
  std::vector<NamedParameter> named;
  std::vector<RowProblem> problems;
};

/// `known`, the row of its name or an empty one, with the properties of `entry`, which replaces those that it
/// names and keeps the rest; with another type, limits, default and words of the old one are dropped. `entry`
/// follows docs/schemas/schema-file.schema.json, with numbers of `kind` and, where it is another than `axis`,
/// with `"flags": true` for words that are joined by `|`; anything else throws an exception of nlohmann.
[[nodiscard]] RowReading read_row(nlohmann::ordered_json const& entry, Parameter const* known,
                                  ListKind kind = ListKind::axis);

}  // namespace axisc::schema
