// JSON schemas of the files that axisc reads, from the tables that it reads them by, and of the findings that
// it writes.
#pragma once

#include "configuration/json_shape.hpp"

#include <span>
#include <string>
#include <string_view>

namespace axisc {

struct JsonFileKind {
  std::string_view name;  ///< "machine"
  configuration::JsonShape const& shape;
};

/// Machine, settings, plant and schema files, findings.
[[nodiscard]] std::span<JsonFileKind const> json_file_kinds();

/// The shape as a JSON schema of draft 2020-12.
[[nodiscard]] std::string json_schema(configuration::JsonShape const& shape);

}  // namespace axisc
