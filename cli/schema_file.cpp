#include "cli/schema_file.hpp"

#include "cli/located_file.hpp"
#include "cli/schema_row.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace axisc::cli {

namespace {

using validator::JsonKind;
using validator::JsonValue;

JsonValue const& parameters_of(LocatedFile const& file) {
  auto const& root = file.root();
  if (root.kind != JsonKind::object) file.refuse(root.span, Text::schema_version);
  JsonValue const* parameters = nullptr;
  bool versioned = false;
  for (auto const& member : root.members) {
    auto const& value = file[member.value];
    if (member.key == "version") {
      versioned = value.kind == JsonKind::number && value.number == 1;
      if (!versioned) file.refuse(value.span, Text::schema_version);
    } else if (member.key == "parameters") {
      if (value.kind != JsonKind::array) file.refuse(value.span, Text::settings_list);
      parameters = &value;
    } else {
      file.refuse(member.key_span, Text::settings_unknown_key,
                  {{"key", member.key}, {"keys", "version, parameters"}});
    }
  }
  if (!versioned || parameters == nullptr) file.refuse(root.span, Text::schema_version);
  return *parameters;
}

schema::Parameter const* known_row(schema::Catalogue const& catalogue, std::string_view name) {
  auto const rows = catalogue.parameters();
  auto const row = std::find_if(rows.begin(), rows.end(),
                                [name](schema::Parameter const& each) { return each.name == name; });
  return row == rows.end() ? nullptr : &*row;
}

/// Entries whose sizes differ from those that are known get slots of their own.
void require_room(LocatedFile const& file, schema::Catalogue const& catalogue,
                  std::vector<SchemaEntry> const& entries) {
  std::size_t slots = catalogue.slot_count();
  for (auto const& entry : entries) {
    auto const* const known = known_row(catalogue, entry.row.name);
    if (known == nullptr || known->array != entry.row.array) slots += schema::slots_of(entry.row.array);
    if (slots > schema::most_slots) {
      file.refuse(entry.span, Text::schema_too_many, {{"count", std::to_string(schema::most_slots)}});
    }
  }
}

}  // namespace

schema::Catalogue with_schema_file(schema::Catalogue const& catalogue, std::string const& path) {
  LocatedFile const file(path, Text::schema_json);
  std::vector<SchemaEntry> entries;
  std::set<std::string> names;
  for (auto const item : parameters_of(file).items) {
    entries.push_back(read_schema_entry(file, file[item], catalogue));
    auto const& entry = entries.back();
    if (!names.insert(entry.row.name).second) {
      file.refuse(entry.span, Text::schema_twice, {{"value", entry.row.name}});
    }
  }
  require_room(file, catalogue, entries);
  std::vector<schema::ParameterRow> rows;
  rows.reserve(entries.size());
  for (auto const& entry : entries) rows.push_back(entry.row);
  auto extended = catalogue.with(std::move(rows));
  for (auto const& entry : entries) {
    for (auto const& named : entry.named) {
      if (!extended.find_number(named.p_axis).empty()) continue;
      file.refuse(named.span, Text::schema_limit_unknown, {{"value", schema::p_axis_text(named.p_axis)}});
    }
  }
  return extended;
}

schema::Catalogue with_schema_files(schema::Catalogue catalogue, std::vector<std::string> const& paths) {
  for (auto const& path : paths) catalogue = with_schema_file(catalogue, path);
  return catalogue;
}

}  // namespace axisc::cli
