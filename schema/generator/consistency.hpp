// What the JSON schema cannot say about the catalogue.
#pragma once

#include "schema/generator/catalogue_data.hpp"

#include <vector>

namespace axisc::schema::generator {

/// Throws DataError with one line per contradiction: repeated names (also without their indices' brackets), array sizes
/// that do not match the name, limits without meaning for the type or that name unknown parameters, minimum above
/// maximum, defaults that are no value of the type, repeated symbols.
void check_consistency(std::vector<ParameterData> const& parameters);

}  // namespace axisc::schema::generator
