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

/// Reads `data_text` and checks it: against the JSON schema `schema_text`, then row by row and across rows
/// (repeated names, limits and defaults that name unknown parameters). Throws DataError with one line per
/// mistake.
[[nodiscard]] std::vector<ParameterRow> read_catalogue(std::string const& data_text,
                                                       std::string const& schema_text);

/// Reads the data of the other kinds of lists, without a JSON schema: data that does not fit throws.
[[nodiscard]] KindRows read_kinds(std::string const& data_text);

}  // namespace axisc::schema::generator
