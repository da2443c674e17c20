// Whether a text is SARIF 2.1.0, or as another JSON schema says.
#pragma once

#include <string>
#include <vector>

namespace axisc::test {

/// What is wrong with it: against tests/data/sarif/structure-2.1.0.schema.json and, where the environment
/// names a file in AXISC_SARIF_SCHEMA, against the schema that OASIS publishes.
[[nodiscard]] std::vector<std::string> sarif_complaints(std::string const& text);

/// What is wrong with `text` against a JSON schema (draft 7).
[[nodiscard]] std::vector<std::string> schema_complaints(std::string const& text, std::string const& schema);

}  // namespace axisc::test
