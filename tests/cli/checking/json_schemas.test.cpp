// The published JSON schemas and the program agree on which files are right.
#include "axisc/settings/plant_file.hpp"
#include "axisc/settings/schema_file.hpp"
#include "axisc/settings/settings.hpp"
#include "cli/checking/json_schema.hpp"
#include "cli/program.hpp"
#include "configuration/json_check.hpp"
#include "configuration/machine_file.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/sarif_schema.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

namespace json_schemas_test {

using namespace axisc::test;
using axisc::configuration::JsonShape;
using Json = nlohmann::ordered_json;

namespace {

struct FileKind {
  std::string schema_file;
  std::string page;
  JsonShape const& shape;
  std::string complete;  ///< a file with every key
};

std::vector<FileKind> const& kinds() {
  static std::vector<FileKind> const all = {
      {"docs/schemas/machine.schema.json", "docs/machine-file.md", axisc::configuration::machine_file_shape,
       R"({
        "machine": "mill", "cycle_time_us": 1000, "default_list": "default.lis",
        "default_channel_list": "sda.lis",
        "axes": [{"name": "X", "list": "x.lis", "drive": "profiDrive", "position_control": "CNC", "type": "t",
                  "drive_delay_us": 2500},
                 {"name": "Y", "list": "y.lis", "drive": "RT Ethernet", "type": "S"}],
        "groups": [{"name": "table", "axes": ["X", "Y"], "programs": ["a.nc"], "channel_list": "sda1.lis",
                    "look_ahead_blocks": 190}],
        "gantries": [{"master": "X", "slaves": ["Y"]}],
        "programs": ["b.nc"], "filter_sets": ["#FILTER ON"], "inch": false,
        "report": {"title": "M", "customer": "C", "author": "A", "date": "today", "tolerance_mm": 0.01}})"},
      {"docs/schemas/settings.schema.json", "docs/settings.md", axisc::settings_shape, R"({
        "cycle_time_us": 62.5, "build": "V3.1.3080.00", "language": "de", "disable": ["AX4007", "delay-too-long"],
        "design": {"filters": "matched", "kernels": "taps-n", "vibration_guard": "rounded",
                   "cycle_time": "half"},
        "motion": {"projection": "longest-ramp", "borders": "continuous", "sine": "whole-change", "circle": "full",
                   "corner": "up-only", "weights": "a-follows-r", "cycles": "whole", "hsc": "trapez"},
        "severity": {"ax3013": "error"}, "schema": ["build.json"],
        "paths": [{"pattern": "old/**", "disable": ["AX1011"], "kind": "tool"}],
        "include": ["**/*.lis"], "exclude": ["old/**"]})"},
      {"docs/schemas/plant.schema.json", "docs/plant-file.md", axisc::plant_file_shape, R"({"plants": [{
        "name": "X", "comment": ["anything"], "motor_mass_kg": 500, "load_mass_kg": 1060, "stiffness_n_per_um": 117.5,
        "damping_n_s_per_mm": 20, "tooth_pitch_mm": 10, "transmission_error_um": 2.8, "structure_mass_kg": 1500,
        "structure_frequency_hz": 11.75, "structure_damping_ratio": 0.015, "dead_time_us": 250,
        "velocity_bandwidth_hz": 57, "velocity_reset_time_ms": 4, "kv_per_s": 60, "feedforward_percent": 44,
        "position_feedback": "motor"}]})"},
      {"docs/schemas/schema-file.schema.json", "docs/schema-files.md", axisc::schema_file_shape,
       R"json({"version": 1, "parameters": [
        {"id": "P-AXIS-00900", "name": "getriebe[].new_limit", "type": "UNS16", "array": [6], "default": "0", "unit": "us",
         "minimum": 1, "maximum": "MAX(UNS16)", "flags": false, "number_names": {"off": 0},
         "former_name": "kenngr.older", "since": "V3.1.3200.00"},
        {"name": "a.b", "type": "REAL64", "unit": {"translatory": "mm", "rotary": "deg"},
         "exclusive_minimum": "P-AXIS-00900", "exclusive_maximum": 1e9},
        {"name": "a.c", "type": "STRING", "symbols": {"OFF": 0, "ON_2": null}, "max_length": 8,
         "axis_types": ["T", "R"]}]})json"}};
  return all;
}

bool reader_accepts(FileKind const& kind, std::string const& text) {
  auto const parsed = axisc::configuration::parse_json(text, 0);
  auto const* const document = std::get_if<axisc::configuration::JsonDocument>(&parsed);
  REQUIRE(document != nullptr);
  return axisc::configuration::check_json(*document, kind.shape).problems.empty();
}

bool schema_accepts(FileKind const& kind, std::string const& text) {
  return schema_complaints(text, read_source_file(kind.schema_file)).empty();
}

/// Both must say the same; gives what they say.
bool accepted(FileKind const& kind, std::string const& text) {
  bool const by_reader = reader_accepts(kind, text);
  INFO(kind.schema_file << ": " << text);
  CHECK(schema_accepts(kind, text) == by_reader);
  return by_reader;
}

void collect_places(Json const& value, Json::json_pointer const& place,
                    std::vector<Json::json_pointer>& places) {
  places.push_back(place);
  if (value.is_object()) {
    for (auto const& [key, member] : value.items()) collect_places(member, place / key, places);
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) collect_places(value[i], place / i, places);
  }
}

std::string text_of(Json const& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// "number, above 0", "`T`, `R` or `S`".
std::string values_of(Json const& schema) {
  if (schema.contains("anyOf") || schema.contains("oneOf")) {
    auto const& choices = schema.at(schema.contains("anyOf") ? "anyOf" : "oneOf");
    // Words in any letter case are one choice, spelled twice.
    if (choices.front().contains("enum")) return values_of(choices.front());
    std::string text;
    for (auto const& choice : choices) text += (text.empty() ? "" : "; or ") + values_of(choice);
    return text;
  }
  if (schema.contains("enum")) {
    std::string text;
    for (auto const& word : schema.at("enum")) text += (text.empty() ? "`" : ", `") + text_of(word) + "`";
    return text;
  }
  auto const type = schema.contains("type") ? text_of(schema.at("type")) : "anything";
  if (type == "string") return "text";
  if (type == "boolean") return "`true` or `false`";
  if (type == "array") return "list";
  if (type != "number" && type != "integer") return type;
  std::string text = type == "integer" ? "whole number" : "number";
  if (schema.contains("minimum")) text += ", from " + text_of(schema["minimum"]);
  if (schema.contains("exclusiveMinimum")) text += ", above " + text_of(schema["exclusiveMinimum"]);
  if (schema.contains("maximum")) text += ", up to " + text_of(schema["maximum"]);
  return text;
}

/// One row per key, those of lists and objects below them as `axes[].name`.
void append_rows(Json const& schema, std::string const& before, std::string& rows) {
  if (!schema.contains("properties")) return;
  auto const required = schema.value("required", Json::array());
  for (auto const& [key, value] : schema.at("properties").items()) {
    bool const is_required = std::find(required.begin(), required.end(), key) != required.end();
    rows += "| `" + before + key + "` | " + values_of(value) + " | " + (is_required ? "yes" : "") + " | " +
            value.value("description", "") + " |\n";
    bool const is_list = value.contains("items");
    append_rows(is_list ? value["items"] : value, before + key + (is_list ? "[]." : "."), rows);
  }
}

/// Names of all keys of a table and of those below it.
void collect_keys(JsonShape const& shape, std::vector<std::string>& keys) {
  for (auto const& key : shape.keys) {
    keys.emplace_back(key.name);
    collect_keys(*key.shape, keys);
  }
  if (shape.items != nullptr) collect_keys(*shape.items, keys);
  for (auto const* const alternative : shape.alternatives) collect_keys(*alternative, keys);
}

}  // namespace

TEST_CASE("the JSON schemas are what the tables of the readers give") {
  for (auto const& kind : kinds()) check_golden(kind.schema_file, json_schema(kind.shape));
}

TEST_CASE("the reference pages have a row for every key, and an example that is right") {
  std::string const begin = "<!-- keys: written by the tests -->\n";
  std::string const end = "<!-- end of keys -->\n";
  std::vector<std::pair<std::string, std::string>> pages{{"docs/findings.md", "finding.schema.json"}};
  for (auto const& kind : kinds()) pages.emplace_back(kind.page, kind.schema_file.substr(13));
  for (auto const& [path, file] : pages) {
    auto page = read_source_file(path);
    auto const schema = read_source_file("docs/schemas/" + file);
    INFO(path);
    auto const from = page.find(begin);
    auto const to = page.find(end);
    REQUIRE(from != std::string::npos);
    REQUIRE(to != std::string::npos);
    std::string table = "| key | value | required | meaning |\n|---|---|---|---|\n";
    append_rows(Json::parse(schema), "", table);
    page.replace(from + begin.size(), to - from - begin.size(), table);
    check_golden(path, page);
    auto const example = page.find("```json\n") + 8;
    auto const complaints =
        schema_complaints(page.substr(example, page.find("```", example) - example), schema);
    CHECK(complaints == std::vector<std::string>());
  }
}

TEST_CASE("a file with every key is right for reader and schema") {
  for (auto const& kind : kinds()) {
    CHECK(accepted(kind, kind.complete));
    std::vector<std::string> keys;
    collect_keys(kind.shape, keys);
    for (auto const& key : keys) {
      INFO(key);
      CHECK(kind.complete.find('"' + key + '"') != std::string::npos);
    }
  }
}

TEST_CASE("the samples are as the schemas say") {
  namespace fs = std::filesystem;
  std::size_t machines = 0;
  for (std::string const folder : {"samples", "tests/cli/data", "validator/rules"}) {
    for (auto const& entry : fs::recursive_directory_iterator(fs::path(AXISC_SOURCE_DIR) / folder)) {
      auto const path = entry.path().lexically_relative(AXISC_SOURCE_DIR).generic_string();
      bool const broken_on_purpose = path.find("/fail/") != std::string::npos;
      if (entry.path().filename() != "machine.json" || broken_on_purpose) continue;
      ++machines;
      INFO(path);
      CHECK(accepted(kinds()[0], read_source_file(path)));
    }
  }
  CHECK(machines > 10);
  CHECK(accepted(kinds()[2], read_source_file("samples/motion/rack/plant.json")));
  CHECK(accepted(kinds()[3], read_source_file("schema/axis-parameters.json")));
}

TEST_CASE("reader and schema refuse the same wherever another value is put") {
  std::vector<Json> const others = {nullptr, true, -1, 0.5, "", "?", Json::array(), Json::object()};
  for (auto const& kind : kinds()) {
    auto const complete = Json::parse(kind.complete);
    std::vector<Json::json_pointer> places;
    collect_places(complete, Json::json_pointer(), places);
    for (auto const& place : places) {
      auto without = complete;
      if (!place.empty() && without[place.parent_pointer()].is_object()) {
        without[place.parent_pointer()].erase(place.back());
        static_cast<void>(accepted(kind, without.dump()));
      }
      for (auto const& other : others) {
        auto changed = complete;
        changed[place] = other;
        static_cast<void>(accepted(kind, changed.dump()));
      }
      if (complete[place].is_object()) {
        auto longer = complete;
        longer[place]["no key of any table"] = Json::object({{"x", 1}});
        CHECK_FALSE(accepted(kind, longer.dump()));
      }
    }
  }
}

TEST_CASE("what is nearly right is refused by both") {
  auto const refused = [](std::size_t kind, std::string const& text) {
    INFO(text);
    CHECK_FALSE(accepted(kinds().at(kind), text));
  };
  refused(0, R"({"axes": []})");
  refused(0, R"({"axes": [{"name": "X", "list": "x.lis", "drive": "SERCOSS"}]})");
  refused(0, R"({"axes": [{"name": "X", "list": "x.lis"}], "cycle_time_us": 1000001})");
  refused(1, R"({"cycle_time_us": 0})");
  refused(1, R"({"build": "new"})");
  refused(1, R"({"language": "fr"})");
  refused(1, R"({"severity": {"AX4007": "fatal"}})");
  refused(1, R"({"paths": [{"disable": []}]})");
  refused(2, R"({"plants": [{"name": "X"}]})");
  refused(3, R"({"version": 2, "parameters": []})");
  refused(3, R"({"version": 1, "parameters": [{"name": "a[].b[].c[]"}]})");
  refused(3, R"({"version": 1, "parameters": [{"name": "a", "minimum": 1, "exclusive_minimum": 1}]})");
  refused(3, R"json({"version": 1, "parameters": [{"name": "a", "maximum": "MAX(STRING)"}]})json");
  refused(3, R"({"version": 1, "parameters": [{"name": "a", "axis_types": ["T", "T"]}]})");
  refused(3, R"({"version": 1, "parameters": [{"name": "a", "symbols": {"low": 1}}]})");
}

}  // namespace json_schemas_test
