#include "axisc/settings/schema_file.hpp"

#include "axisc/settings/located_file.hpp"
#include "axisc/settings/schema_row.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace axisc::says {

constexpr Sentence schema_json{"the schema file is not valid JSON here",
                               "die Schemadatei ist hier kein gültiges JSON"};
constexpr Sentence twice{"\"{value}\" is in this file twice", "\"{value}\" steht zweimal in dieser Datei"};
constexpr Sentence too_many{"more than {count} single parameters; reduce the array sizes",
                            "mehr als {count} einzelne Parameter; die Feldgrößen verkleinern"};
constexpr Sentence limit_unknown{"no parameter has the number {value}; add it to this file",
                                 "kein Parameter hat die Nummer {value}; in dieser Datei ergänzen"};

}  // namespace axisc::says

namespace axisc {

namespace {

using configuration::JsonKey;
using configuration::JsonShape;
using Kind = configuration::JsonShapeKind;
using enum configuration::JsonPresence;

constexpr JsonShape version{.kind = Kind::whole_number, .lowest = 1, .highest = 1};

constexpr JsonShape rows_shape{.kind = Kind::list, .items = &schema_row_shape};
constexpr std::array schema_file_keys = {
    JsonKey{"version", &version, required, "Version of this layout."},
    JsonKey{"parameters", &rows_shape, required,
            "Parameters that are new, or of which something is said anew."}};

schema::Parameter const* known_row(schema::Catalogue const& catalogue, std::string_view name) {
  auto const rows = catalogue.parameters();
  auto const row = std::find_if(rows.begin(), rows.end(),
                                [name](schema::Parameter const& each) { return each.name == name; });
  return row == rows.end() ? nullptr : &*row;
}

struct Entry {
  configuration::JsonValue const& json;
  schema::RowReading reading;
};

Span name_of(LocatedFile const& file, Entry const& entry) {
  return file.find(entry.json, "name")->span;
}

/// Entries whose sizes differ from the known ones get slots of their own.
void require_room(LocatedFile const& file, schema::Catalogue const& catalogue,
                  std::vector<Entry> const& entries) {
  std::size_t slots = catalogue.slot_count();
  for (auto const& entry : entries) {
    auto const& row = entry.reading.row;
    auto const* const known = known_row(catalogue, row.name);
    if (known == nullptr || known->array != row.array) slots += schema::slots_of(row.array);
    if (slots > schema::most_slots) {
      file.refuse(name_of(file, entry), says::too_many, {{"count", std::to_string(schema::most_slots)}});
    }
  }
}

}  // namespace

constexpr JsonShape schema_file_shape{.kind = Kind::object,
                                      .title = "Schema file of axisc: parameters of the control",
                                      .keys = schema_file_keys};

schema::Catalogue with_schema_file(schema::Catalogue const& catalogue, std::string const& path) {
  LocatedFile const file(path, schema_file_shape, says::schema_json);
  auto const document = nlohmann::ordered_json::parse(file.bytes());
  auto const& items = file.find(file.root(), "parameters")->items;
  std::vector<Entry> entries;
  std::set<std::string> names;
  for (std::size_t i = 0; i < items.size(); ++i) {
    auto const& json = document.at("parameters").at(i);
    entries.push_back({file[items[i]], read_schema_entry(file, file[items[i]], json, catalogue)});
    auto const& name = entries.back().reading.row.name;
    if (!names.insert(name).second) {
      file.refuse(name_of(file, entries.back()), says::twice, {{"value", name}});
    }
  }
  require_room(file, catalogue, entries);
  std::vector<schema::ParameterRow> rows;
  rows.reserve(entries.size());
  for (auto const& entry : entries) rows.push_back(entry.reading.row);
  auto extended = catalogue.with(std::move(rows));
  for (auto const& entry : entries) {
    for (auto const& named : entry.reading.named) {
      if (!extended.find_number(named.p_axis).empty()) continue;
      auto const* const value = file.find(entry.json, named.key);
      file.refuse(value == nullptr ? name_of(file, entry) : value->span, says::limit_unknown,
                  {{"value", schema::p_axis_text(named.p_axis)}});
    }
  }
  return extended;
}

schema::Catalogue with_schema_files(schema::Catalogue catalogue, std::vector<std::string> const& paths) {
  for (auto const& path : paths) catalogue = with_schema_file(catalogue, path);
  return catalogue;
}

}  // namespace axisc
