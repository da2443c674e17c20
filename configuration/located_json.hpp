// JSON with the place of every key and value, for findings with line and column.
#pragma once

#include "diagnostics/message.hpp"
#include "diagnostics/span.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace axisc::configuration {

enum class JsonKind : std::uint8_t { null, boolean, number, string, array, object };

struct JsonMember {
  std::string key;
  Span key_span;          ///< quotes included
  std::size_t value = 0;  ///< index into JsonDocument::values
};

struct JsonValue {
  JsonKind kind = JsonKind::null;
  Span span;  ///< of a string or number the token; of an array or object its opening bracket
  bool flag = false;
  double number = 0;
  std::string string;
  std::vector<std::size_t> items;   ///< of an array; indices into JsonDocument::values
  std::vector<JsonMember> members;  ///< of an object, in the order of the text; keys may repeat

  /// The first member of that name; null if there is none.
  [[nodiscard]] JsonMember const* find(std::string_view key) const;
};

/// The values of one text; the first one is the document.
struct JsonDocument {
  std::vector<JsonValue> values;

  [[nodiscard]] JsonValue const& root() const { return values.front(); }
  [[nodiscard]] JsonValue const& operator[](std::size_t index) const { return values[index]; }
};

/// The place where a text is not valid JSON.
struct JsonError {
  Span span;  ///< the token that does not fit; empty at the end of the text
  std::optional<Message> reason = std::nullopt;  ///< for the usual mistakes
};

/// Deepest nesting that is read; a deeper bracket is an error.
inline constexpr std::size_t deepest_json = 64;

/// The text starts at offset `text_begin` of `bytes` (after a byte order mark).
[[nodiscard]] std::variant<JsonDocument, JsonError> parse_json(std::string_view bytes,
                                                               std::uint32_t text_begin);

}  // namespace axisc::configuration
