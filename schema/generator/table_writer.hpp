// Writes the checked catalogue as constant tables in C++.
#pragma once

#include "schema/parameter_row.hpp"

#include <string>
#include <vector>

namespace axisc::schema::generator {

/// The text of catalogue_tables.inc, which catalogue.cpp includes. Equal data gives equal text.
[[nodiscard]] std::string write_tables(std::vector<ParameterRow> const& parameters);

/// The text of vocabulary_tables.inc, which built_in_vocabulary.cpp includes.
[[nodiscard]] std::string write_vocabulary(std::vector<ParameterRow> const& parameters);

}  // namespace axisc::schema::generator
