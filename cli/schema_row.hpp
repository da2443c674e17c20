// One entry of a schema file.
#pragma once

#include "cli/located_file.hpp"
#include "schema/parameter_row.hpp"

#include <cstdint>
#include <vector>

namespace axisc::cli {

/// A parameter that an entry names by its number; it may stand further down in the file.
struct NamedNumber {
  Span span;
  std::uint16_t p_axis = 0;
};

struct SchemaEntry {
  schema::ParameterRow row;
  std::vector<NamedNumber> named;  ///< limits and a default that are other parameters
  Span span;                       ///< of the name
};

/// The row that `entry` makes of the catalogue's row of that name, or a new one. Failure for what it must not say.
[[nodiscard]] SchemaEntry read_schema_entry(LocatedFile const& file, validator::JsonValue const& entry,
                                            schema::Catalogue const& catalogue);

}  // namespace axisc::cli
