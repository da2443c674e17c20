// The JSON schema of a file, from the table that axisc reads it by.
#pragma once

#include "configuration/json_shape.hpp"

#include <string>

namespace axisc::test {

/// Of draft 2020-12.
[[nodiscard]] std::string json_schema(configuration::JsonShape const& shape);

}  // namespace axisc::test
