// Checks a JSON document against a table.
#pragma once

#include "configuration/json_shape.hpp"
#include "configuration/located_json.hpp"
#include "diagnostics/message.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc::configuration {

struct JsonProblem {
  Span span;  ///< of the key or value that is wrong; of the object's bracket where a key is missing
  Message message;
  std::optional<Span> first;  ///< of a repeated key: where it is for the first time
  std::string suggestion;     ///< what was probably meant to be at `span`, without quotes; may be empty
  std::string number;         ///< for a text that was meant to be a number: "1000"; may be empty
  std::string known_keys;     ///< for an unknown key: "name, list, drive"
};

struct JsonCheck {
  /// Findings: for each object its members in the order of the text, then its missing keys.
  std::vector<JsonProblem> problems;
  /// By index of the document's values: whether a value may be read. A list or object may be readable
  /// although something in it is not.
  std::vector<bool> readable;
};

/// The first of repeated keys counts. The values of unknown keys are not checked.
[[nodiscard]] JsonCheck check_json(JsonDocument const& document, JsonShape const& shape);

}  // namespace axisc::configuration
