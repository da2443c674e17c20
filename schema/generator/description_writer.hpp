// Writes the descriptions of parameters as constant tables in C++.
#pragma once

#include "schema/parameter_row.hpp"

#include <string>
#include <vector>

namespace axisc::schema::generator {

/// The text of description_tables.inc, which description.cpp includes. `data_text` is axis-descriptions.json;
/// throws DataError with one line per mistake.
[[nodiscard]] std::string write_descriptions(std::vector<ParameterRow> const& parameters,
                                             std::string const& data_text);

}  // namespace axisc::schema::generator
