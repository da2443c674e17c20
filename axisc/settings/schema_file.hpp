// Schema files: parameters of other builds of the control, in the form of schema/axis-parameters.json.
//
//   {
//     "version": 1,
//     "parameters": [
//       {"id": "P-AXIS-00900", "name": "getriebe[].new_limit", "type": "UNS32", "array": [6], "default": "0",
//        "maximum": 500},
//       {"name": "getriebe[].dynamik.vb_max", "maximum": 3000000}
//     ]
//   }
//
// An entry for a known name overrides the properties it has and keeps the others; an entry with another type
// starts from scratch. Later files override earlier ones.
#pragma once

#include "configuration/json_shape.hpp"
#include "schema/catalogue.hpp"

#include <string>
#include <vector>

namespace axisc {

/// The shape of a schema file; axis-parameters.json is one.
extern configuration::JsonShape const schema_file_shape;

/// `catalogue` with the entries of the file. Failure, with line and column, for anything that is not a schema
/// file.
[[nodiscard]] schema::Catalogue with_schema_file(schema::Catalogue const& catalogue, std::string const& path);

/// `catalogue` with the entries of several files, in their order.
[[nodiscard]] schema::Catalogue with_schema_files(schema::Catalogue catalogue,
                                                  std::vector<std::string> const& paths);

}  // namespace axisc
