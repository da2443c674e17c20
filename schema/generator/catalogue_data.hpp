// The catalogues as the generator sees them: the rows of axis-parameters.json and of other-lists.json,
// checked.
#pragma once

#include "schema/generator/kind_writer.hpp"
#include "schema/parameter_row.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace axisc::schema::generator {

/// A mistake in the data, in words for the person who edits it.
class DataError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads `data_text` and checks it, row by row and across rows (repeated names, limits and defaults that name
/// unknown parameters). Throws DataError with one line per mistake. A test compares the data with the JSON
/// schema docs/schemas/schema-file.schema.json, whose checker takes long to compile.
[[nodiscard]] std::vector<ParameterRow> read_catalogue(std::string const& data_text);

/// Reads the data of the other kinds of lists, in the same way.
[[nodiscard]] KindRows read_kinds(std::string const& data_text);

}  // namespace axisc::schema::generator
