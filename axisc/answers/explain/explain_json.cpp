#include "axisc/answers/explain/explain_formats.hpp"
#include "axisc/answers/explain/parameter_facts.hpp"
#include "axisc/answers/json_text.hpp"
#include "diagnostics/location.hpp"
#include "schema/descriptions/description.hpp"

#include <nlohmann/json.hpp>

namespace axisc {

namespace {

using nlohmann::ordered_json;

ordered_json limit_json(schema::ListKind kind, schema::Limit const& limit) {
  switch (limit.kind) {
    case schema::Limit::Kind::none:
      return nullptr;
    case schema::Limit::Kind::number:
      return {{"number", limit.number}, {"open", limit.open}};
    case schema::Limit::Kind::parameter:
      return {{"p_axis", schema::number_text(kind, limit.p_axis)}, {"open", limit.open}};
  }
  return nullptr;
}

ordered_json text_json(std::string_view text) {
  return text.empty() ? ordered_json(nullptr) : ordered_json(text);
}

ordered_json symbols_json(std::span<schema::Symbol const> symbols) {
  auto json = ordered_json::array();
  for (auto const& symbol : symbols) {
    json.push_back({{"word", symbol.word},
                    {"number", symbol.number ? ordered_json(*symbol.number) : ordered_json(nullptr)}});
  }
  return json;
}

ordered_json rule_json(validator::Rule const& rule, Language language) {
  return {{"code", code_text(rule.code)},
          {"name", rule.name},
          {"severity", severity_name(rule.severity)},
          {"control", text_json(rule.control)},
          {"needs_cycle_time", rule.needs == validator::Needs::cycle_time},
          {"page", page(rule).in(language)}};
}

ordered_json parameter_json(schema::Catalogue const& catalogue, schema::Parameter const& parameter,
                            Language language) {
  ordered_json json{{"name", parameter.name},
                    {"p_axis", text_json(schema::number_text(parameter.kind, parameter.p_axis))},
                    {"list", schema::row_of(parameter.kind).word},
                    {"type", schema::data_type_name(parameter.type)}};
  json["default"] = parameter.has_default ? ordered_json(default_text(parameter)) : ordered_json(nullptr);
  json["minimum"] = limit_json(parameter.kind, parameter.minimum);
  json["maximum"] = limit_json(parameter.kind, parameter.maximum);
  json["unit"] = {{"translatory", text_json(parameter.unit_translatory)},
                  {"rotary", text_json(parameter.unit_rotary)}};
  json["entries"] = ordered_json::array();
  for (std::size_t i = 0; i < parameter.index_count(); ++i) json["entries"].push_back(parameter.array[i]);
  json["symbols"] = symbols_json(parameter.symbols);
  json["number_names"] = symbols_json(parameter.number_names);
  json["max_length"] = parameter.max_length > 0 ? ordered_json(parameter.max_length) : ordered_json(nullptr);
  json["axis_types"] = parameter.axis_types.empty() ? "TRS" : std::string(parameter.axis_types);
  json["since"] = text_json(parameter.since);
  auto const description = schema::description_of(parameter);
  json["meaning"] = text_json(description.what.in(language));
  json["detail"] = text_json(description.detail.in(language));
  json["inferred"] = description.inferred;
  json["restart"] = description.restart;
  json["values"] = ordered_json::array();
  for (auto const& [value, meaning] : description.values) {
    json["values"].push_back({{"value", value}, {"meaning", meaning.in(language)}});
  }
  json["ranges_by_type"] = ranges_by_type(parameter, language);
  json["file"] = text_json(catalogue.file_of(parameter));
  json["manual"] = text_json(manual_section(parameter, language));
  json["rules"] = rules_about(parameter);
  return json;
}

}  // namespace

std::string explain_json(schema::Catalogue const& catalogue, std::span<validator::Rule const* const> rules,
                         std::span<schema::Parameter const* const> parameters, Language language) {
  ordered_json json{{"version", 1}, {"rules", ordered_json::array()}, {"parameters", ordered_json::array()}};
  for (auto const* const rule : rules) json["rules"].push_back(rule_json(*rule, language));
  for (auto const* const parameter : parameters) {
    json["parameters"].push_back(parameter_json(catalogue, *parameter, language));
  }
  return json_document(json);
}

}  // namespace axisc
