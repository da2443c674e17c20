// Shapes of JSON files, as tables of keys: kind, range, meaning, and where the value is stored. One table
// checks a file (json_check.hpp), reads it (json_reading.hpp), and gives its JSON schema in docs/schemas.
#pragma once

#include "configuration/sentences.hpp"
#include "design/units.hpp"
#include "diagnostics/message.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

namespace axisc::configuration {

class JsonReading;
struct JsonShape;
struct JsonValue;

/// Stores a value that matches its shape in an object of the program; made by into() and by().
using JsonStore = void (*)(JsonReading const& reading, JsonShape const& shape, JsonValue const& value,
                           void* target);

enum class JsonPresence : std::uint8_t { optional, required };

struct JsonKey {
  std::string_view name;
  JsonShape const* shape = nullptr;
  JsonPresence presence = JsonPresence::optional;
  std::string_view description;    ///< for JSON schemas, in English
  JsonStore store = nullptr;       ///< none where the value is looked up instead
  std::string_view excludes = {};  ///< another key that the object must not have as well
};

enum class JsonShapeKind : std::uint8_t {
  anything,
  null,
  flag,
  number,
  whole_number,
  text,
  list,
  object,  ///< with the keys of a table
  map,     ///< an object whose keys are names chosen by the user
  either,  ///< one of several shapes
};

/// The shape of one value. Each field applies to the kinds that its comment names.
struct JsonShape {
  JsonShapeKind kind = JsonShapeKind::text;
  std::string_view title = {};  ///< object: what it is, for JSON schemas

  double lowest = -std::numeric_limits<double>::infinity();  ///< numbers
  double highest = std::numeric_limits<double>::infinity();  ///< numbers
  bool above_lowest = false;                                 ///< numbers: `lowest` itself is not allowed

  bool may_be_empty = false;                         ///< text
  std::span<std::string_view const> words = {};      ///< text: one of these, where there are any
  bool ignores_case = false;                         ///< text: the words may be written in any letter case
  bool (*accepts)(std::string_view text) = nullptr;  ///< text: a test of its own
  std::string_view pattern = {};                     ///< text: the test as a regular expression, or nearly

  JsonShape const* items = nullptr;  ///< list, map: each value
  JsonShape const* names = nullptr;  ///< map: each key, a text
  std::size_t fewest = 0;            ///< list, map
  std::size_t most = SIZE_MAX;       ///< list
  bool distinct = false;             ///< list of texts: none of them twice

  std::span<JsonKey const> keys = {};                   ///< object
  std::span<JsonShape const* const> alternatives = {};  ///< either

  /// Replaces the general sentence if a value is of the right kind but wrong; required for `either`, which
  /// has no general sentence. May contain {key} and {value}.
  std::optional<SentenceRef> sentence = {};
};

inline constexpr JsonShape any_json{.kind = JsonShapeKind::anything};
inline constexpr JsonShape json_flag{.kind = JsonShapeKind::flag};
inline constexpr JsonShape json_null{.kind = JsonShapeKind::null};
inline constexpr JsonShape json_text{};  ///< not empty
inline constexpr JsonShape json_texts{.kind = JsonShapeKind::list, .items = &json_text};
/// Microseconds, from a nanosecond to a second.
inline constexpr JsonShape json_cycle_time{.kind = JsonShapeKind::number,
                                           .lowest = design::shortest_cycle_time.microseconds(),
                                           .highest = design::longest_cycle_time.microseconds(),
                                           .sentence = says::json_cycle_time};

}  // namespace axisc::configuration
