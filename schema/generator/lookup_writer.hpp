// Writes what people look for as constant tables in C++: schema/lookup/lookup.hpp.
#pragma once

#include "schema/parameter_row.hpp"

#include <string>
#include <vector>

namespace axisc::schema::generator {

/// The text of lookup_tables.inc, which lookup.cpp includes, from control-messages.json and lookup.json.
/// Throws DataError with one line per mistake: a text that is missing in a language, a number, a name or a
/// word that is there twice, a parameter that the catalogue lacks.
[[nodiscard]] std::string write_lookup(std::vector<ParameterRow> const& parameters,
                                       std::string const& messages_text, std::string const& lookup_text);

}  // namespace axisc::schema::generator
