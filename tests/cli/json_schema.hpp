// JSON schemas of the files that axisc reads, from the tables that it reads them by.
#pragma once

#include "configuration/json_shape.hpp"

#include <string>

namespace axisc::test {

/// The shape as a JSON schema of draft 7.
[[nodiscard]] std::string json_schema(configuration::JsonShape const& shape);

}  // namespace axisc::test
