// One row of the catalogue that owns its texts: a row that a schema file adds or replaces.
#pragma once

#include "schema/catalogue.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace axisc::schema {

/// The fields are those of Parameter.
struct ParameterRow {
  using Words = std::vector<std::pair<std::string, std::optional<int>>>;

  std::string name;
  std::uint16_t p_axis = 0;
  DataType type{};
  std::optional<std::string> default_text;
  ArraySizes array{};
  bool is_flags = false;
  ListKind kind = ListKind::axis;
  std::string unit_translatory, unit_rotary;
  Limit minimum, maximum;
  Words symbols;  ///< of a boolean with FALSE and TRUE
  Words number_names;
  std::uint16_t max_length = 0;
  std::string axis_types;
  std::string former_name;
  std::string since;
  std::string file;  ///< where the row comes from

  /// A copy to be changed.
  [[nodiscard]] static ParameterRow from(Parameter const& parameter);
  /// The row as the catalogue holds it, with texts that live as long as this; its symbols and slots are
  /// empty.
  [[nodiscard]] Parameter view() const;
};

/// Concrete parameters of a row with these array sizes.
[[nodiscard]] std::size_t slots_of(ArraySizes const& array);

}  // namespace axisc::schema
