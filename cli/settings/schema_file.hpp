// Schema files: parameters of other builds of the control, in the form of schema/axis-parameters.json.
//
//   {
//     "version": 1,
//     "parameters": [
//       {"id": "P-AXIS-00900", "name": "getriebe[].new_limit", "type": "UNS32", "array": [6], "default": "0", "maximum": 500},
//       {"name": "getriebe[].dynamik.vb_max", "maximum": 3000000}
//     ]
//   }
//
// An entry for a known name says anew what it names and leaves the rest; one with another type begins afresh. A file that
// is named later wins.
#pragma once

#include "configuration/json_shape.hpp"
#include "schema/catalogue.hpp"

#include <string>
#include <vector>

namespace axisc::cli {

/// What a schema file may say; axis-parameters.json is one.
extern configuration::JsonShape const schema_file_shape;

/// `catalogue` with the entries of the file. Failure, with line and column, for anything that is no schema file.
[[nodiscard]] schema::Catalogue with_schema_file(schema::Catalogue const& catalogue, std::string const& path);

/// The same for several files, one behind the other.
[[nodiscard]] schema::Catalogue with_schema_files(schema::Catalogue catalogue,
                                                  std::vector<std::string> const& paths);

}  // namespace axisc::cli
