// One entry of a schema file.
#pragma once

#include "cli/settings/located_file.hpp"
#include "configuration/json_shape.hpp"
#include "schema/row_reading.hpp"

namespace axisc::cli {

/// What an entry may say.
extern configuration::JsonShape const schema_row_shape;

/// `entry` of `file` as `json` says it too: the row that it makes of the catalogue's row of its name, or a new one. Failure
/// for what contradicts itself or the catalogue. Parameters that it names may be unknown yet.
[[nodiscard]] schema::RowReading read_schema_entry(LocatedFile const& file,
                                                   configuration::JsonValue const& entry,
                                                   nlohmann::ordered_json const& json,
                                                   schema::Catalogue const& catalogue);

}  // namespace axisc::cli
