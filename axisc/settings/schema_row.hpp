// One entry of a schema file.
#pragma once

#include "axisc/settings/located_file.hpp"
#include "configuration/json_shape.hpp"
#include "schema/row_reading.hpp"

namespace axisc {

/// The shape of an entry.
extern configuration::JsonShape const schema_row_shape;

/// `entry` of `file`, given a second time as `json`: the catalogue's row of that name with the entry applied,
/// or a new row. Failure for contradictions in the entry or with the catalogue. Parameters that it refers to
/// may still be unknown.
[[nodiscard]] schema::RowReading read_schema_entry(LocatedFile const& file,
                                                   configuration::JsonValue const& entry,
                                                   nlohmann::ordered_json const& json,
                                                   schema::Catalogue const& catalogue);

}  // namespace axisc
