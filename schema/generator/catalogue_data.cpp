#include "schema/generator/catalogue_data.hpp"

#include "schema/data_type.hpp"
#include "schema/generator/consistency.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

namespace axisc::schema::generator {
namespace {

// Symbols keep the order of the file: messages list them that way.
using Json = nlohmann::ordered_json;

nlohmann::json parse_json(std::string const& text, std::string_view what) {
  try {
    return nlohmann::json::parse(text);
  } catch (nlohmann::json::parse_error const& error) {
    throw DataError(std::string(what) + ": " + error.what());
  }
}

void check_against_schema(nlohmann::json const& data, nlohmann::json const& schema_document) {
  valijson::Schema schema;
  valijson::SchemaParser(valijson::SchemaParser::kDraft7)
      .populateSchema(valijson::adapters::NlohmannJsonAdapter(schema_document), schema);
  valijson::ValidationResults results;
  valijson::Validator validator(valijson::Validator::kStrongTypes);
  if (validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(data), &results)) return;
  std::string message;
  for (valijson::ValidationResults::Error error; results.popError(error);) {
    for (std::string const& step : error.context) message += step;
    message += ": " + error.description + "\n";
  }
  throw DataError(message);
}

std::uint16_t p_axis_number(std::string const& identifier) {
  constexpr std::string_view prefix = "P-AXIS-";
  std::uint16_t number = 0;
  std::from_chars(identifier.data() + prefix.size(), identifier.data() + identifier.size(), number);
  return number;
}

/// MAX(UNS32) and the like.
double data_type_limit(std::string_view text) {
  std::size_t const begin = text.find('(') + 1;
  std::string_view const name = text.substr(begin, text.size() - begin - 1);
  auto const row = std::find_if(data_types.begin(), data_types.end(),
                                [name](DataTypeRow const& known) { return known.name == name; });
  if (row == data_types.end() || !is_number(row->type))
    throw DataError(std::string(text) + " is not a limit");
  DataRange const range = data_range(row->type);
  return text.starts_with("MIN") ? range.lowest : range.highest;
}

std::optional<LimitData> read_limit(Json const& row, std::string const& closed_key) {
  std::string const open_key = "exclusive_" + closed_key;
  bool const open = row.contains(open_key);
  if (!open && !row.contains(closed_key)) return std::nullopt;
  Json const& value = row.at(open ? open_key : closed_key);
  if (value.is_number()) return LimitData{.open = open, .number = value.get<double>(), .p_axis = 0};
  auto const text = value.get<std::string>();
  if (text.starts_with("P-AXIS-")) {
    return LimitData{.open = open, .number = {}, .p_axis = p_axis_number(text)};
  }
  return LimitData{.open = open, .number = data_type_limit(text), .p_axis = 0};
}

std::vector<SymbolData> read_symbols(Json const& row, std::string const& key) {
  std::vector<SymbolData> symbols;
  if (!row.contains(key)) return symbols;
  for (auto const& [word, number] : row.at(key).items()) {
    symbols.push_back(
        {.word = word, .number = number.is_null() ? std::nullopt : std::optional(number.get<int>())});
  }
  return symbols;
}

ParameterData read_parameter(Json const& row) {
  ParameterData parameter;
  parameter.name = row.at("name").get<std::string>();
  if (row.contains("id")) parameter.p_axis = p_axis_number(row.at("id").get<std::string>());
  parameter.type = row.at("type").get<std::string>();
  if (row.contains("array")) parameter.array = row.at("array").get<std::vector<std::uint16_t>>();
  if (row.contains("default")) parameter.default_text = row.at("default").get<std::string>();
  if (row.contains("unit")) {
    Json const& unit = row.at("unit");
    parameter.unit_translatory = (unit.is_string() ? unit : unit.at("translatory")).get<std::string>();
    parameter.unit_rotary = (unit.is_string() ? unit : unit.at("rotary")).get<std::string>();
  }
  parameter.minimum = read_limit(row, "minimum");
  parameter.maximum = read_limit(row, "maximum");
  if (parameter.type == "BOOLEAN") {
    parameter.symbols = {{.word = "FALSE", .number = 0}, {.word = "TRUE", .number = 1}};
  }
  for (SymbolData& symbol : read_symbols(row, "symbols")) parameter.symbols.push_back(std::move(symbol));
  parameter.number_names = read_symbols(row, "number_names");
  parameter.max_length = row.value("max_length", std::uint16_t{0});
  if (row.contains("axis_types")) {
    for (Json const& type : row.at("axis_types")) parameter.axis_types += type.get<std::string>();
  }
  parameter.since = row.value("since", std::string{});
  return parameter;
}

}  // namespace

std::vector<ParameterData> read_catalogue(std::string const& data_text, std::string const& schema_text) {
  check_against_schema(parse_json(data_text, "data"), parse_json(schema_text, "schema"));
  std::vector<ParameterData> parameters;
  Json const data = Json::parse(data_text);
  for (Json const& row : data.at("parameters")) parameters.push_back(read_parameter(row));
  check_consistency(parameters);
  return parameters;
}

}  // namespace axisc::schema::generator
