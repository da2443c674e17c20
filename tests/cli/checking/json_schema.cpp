#include "cli/checking/json_schema.hpp"

#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>

#include <nlohmann/json.hpp>

namespace axisc::test {

namespace {

using Json = nlohmann::ordered_json;
using configuration::JsonKey;
using configuration::JsonPresence;
using configuration::JsonShape;
using Kind = configuration::JsonShapeKind;

Json schema_of(JsonShape const& shape);

/// Whole numbers without a fraction.
Json number(double value) {
  if (value == std::floor(value) && std::abs(value) < 1e15) return static_cast<std::int64_t>(value);
  return value;
}

/// "^([Cc][Nn][Cc])$": regular expressions of JSON schemas have no flags.
std::string pattern_without_case(std::span<std::string_view const> words) {
  std::string pattern;
  for (std::string_view const word : words) {
    pattern += pattern.empty() ? "^(" : "|";
    for (char const letter : word) {
      bool const is_letter = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
      if (!is_letter) {
        pattern += letter;
        continue;
      }
      pattern += {'[', static_cast<char>(letter & ~0x20), static_cast<char>(letter | 0x20), ']'};
    }
  }
  return pattern + ")$";
}

Json text_schema(JsonShape const& shape) {
  if (!shape.words.empty()) {
    Json words{{"enum", Json(std::vector<std::string>(shape.words.begin(), shape.words.end()))}};
    if (!shape.ignores_case) return words;
    // The first alternative is what editors offer.
    return {{"anyOf", {words, {{"type", "string"}, {"pattern", pattern_without_case(shape.words)}}}}};
  }
  Json schema{{"type", "string"}};
  if (!shape.pattern.empty()) {
    schema["pattern"] = shape.pattern;
  } else if (!shape.may_be_empty) {
    schema["minLength"] = 1;
  }
  return schema;
}

Json number_schema(JsonShape const& shape) {
  Json schema{{"type", shape.kind == Kind::number ? "number" : "integer"}};
  if (std::isfinite(shape.lowest)) {
    schema[shape.above_lowest ? "exclusiveMinimum" : "minimum"] = number(shape.lowest);
  }
  if (std::isfinite(shape.highest)) schema["maximum"] = number(shape.highest);
  return schema;
}

Json object_schema(JsonShape const& shape) {
  Json schema{{"type", "object"}, {"additionalProperties", false}};
  Json required = Json::array();
  Json properties = Json::object();
  Json exclusions = Json::array();
  for (JsonKey const& key : shape.keys) {
    Json property{{"description", key.description}};
    property.update(schema_of(*key.shape));
    properties[std::string(key.name)] = std::move(property);
    if (key.presence == JsonPresence::required) required.push_back(key.name);
    if (!key.excludes.empty()) {
      exclusions.push_back({{"not", {{"required", {key.excludes, key.name}}}}});
    }
  }
  if (!required.empty()) schema["required"] = std::move(required);
  schema["properties"] = std::move(properties);
  if (!exclusions.empty()) schema["allOf"] = std::move(exclusions);
  return schema;
}

Json schema_of_kind(JsonShape const& shape) {
  switch (shape.kind) {
    case Kind::anything: return Json::object();
    case Kind::null: return {{"type", "null"}};
    case Kind::flag: return {{"type", "boolean"}};
    case Kind::number:
    case Kind::whole_number: return number_schema(shape);
    case Kind::text: return text_schema(shape);
    case Kind::list: {
      Json schema{{"type", "array"}};
      if (shape.fewest != 0) schema["minItems"] = shape.fewest;
      if (shape.most != SIZE_MAX) schema["maxItems"] = shape.most;
      if (shape.distinct) schema["uniqueItems"] = true;
      schema["items"] = schema_of(*shape.items);
      return schema;
    }
    case Kind::object: return object_schema(shape);
    case Kind::map: {
      Json schema{{"type", "object"}};
      if (shape.fewest != 0) schema["minProperties"] = shape.fewest;
      schema["propertyNames"] = schema_of(*shape.names);
      schema["additionalProperties"] = schema_of(*shape.items);
      return schema;
    }
    case Kind::either: break;
  }
  Json alternatives = Json::array();
  for (JsonShape const* const alternative : shape.alternatives) {
    alternatives.push_back(schema_of(*alternative));
  }
  return {{"anyOf", std::move(alternatives)}};
}

Json schema_of(JsonShape const& shape) {
  Json schema = Json::object();
  if (!shape.title.empty()) schema["title"] = shape.title;
  schema.update(schema_of_kind(shape));
  return schema;
}

}  // namespace

std::string json_schema(JsonShape const& shape) {
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"}};
  schema.update(schema_of(shape));
  return schema.dump(2) + "\n";
}

}  // namespace axisc::test
