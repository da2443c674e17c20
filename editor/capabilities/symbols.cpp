#include "editor/capabilities/symbols.hpp"

#include "axisc/answers/explain/search.hpp"
#include "diagnostics/ascii.hpp"
#include "editor/reading/open_machines.hpp"
#include "editor/reading/places.hpp"
#include "schema/indexed_name.hpp"
#include "validator/loading/loader.hpp"
#include "validator/views/units_text.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace axisc::editor {

namespace {

enum class SymbolKind : int { property = 7, object = 19 };

/// What a line adds to the summary of its filter, "BANDSTOP 42 Hz".
std::string summary(std::string_view key, std::string_view value, Language language) {
  if (key == "type") return std::string(value);
  if (key != "fg_f0") return {};
  auto const number = schema::read_real(value);
  return number.status == schema::NumberStatus::good ? validator::physical(number.number, "Hz").in(language)
                                                     : "";
}

/// The parameters that the query means, as `axisc explain` finds them: by name, by people's words, with a
/// typing error; for a topic such as "notch filter" those that it refers to.
std::set<std::string_view> meant_parameters(schema::Catalogue const& of_axes, std::string const& query) {
  std::vector const catalogues{of_axes};
  std::set<std::string_view> names;
  for (auto const& hit : search(catalogues, query)) {
    if (hit.likeness > Likeness::slip) break;
    if (auto const* const parameter = std::get_if<schema::Parameter const*>(&hit.subject)) {
      names.insert((*parameter)->name);
    } else if (auto const* const topic = std::get_if<schema::Topic const*>(&hit.subject)) {
      names.insert((*topic)->see.begin(), (*topic)->see.end());
    }
  }
  return names;
}

}  // namespace

Json symbols(OpenMachines& machines, Json const& params) {
  auto const& asked = machines.asked(params);
  auto families = Json::array();
  if (!is_list(asked.path)) return families;
  SourceText const text(asked.path, asked.text);
  auto const tree = grammar::parse_axis_list(text);
  TextLines const lines(asked.text, machines.encoding());
  for (auto const& line : tree.assignments) {
    auto name = text.slice(line.name);
    auto const family = schema::take_part(name);
    auto const value = text.utf8(line.value);
    auto const range = range_json(lines.position(line.name.begin), lines.position(line.value.end));
    Json symbol = {{"name", name.empty() ? family : name},
                   {"detail", value},
                   {"kind", static_cast<int>(SymbolKind::property)},
                   {"range", range},
                   {"selectionRange", range}};
    if (name.empty()) {
      families.push_back(std::move(symbol));
      continue;
    }
    bool const is_new = families.empty() || families.back()["name"] != family;
    if (is_new) {
      families.push_back({{"name", family},
                          {"detail", ""},
                          {"kind", static_cast<int>(SymbolKind::object)},
                          {"range", range},
                          {"selectionRange", range},
                          {"children", Json::array()}});
    }
    auto& last = families.back();
    last["range"]["end"] = range["end"];
    last["children"].push_back(std::move(symbol));
    auto const shown = summary(name, value, machines.language());
    if (shown.empty()) continue;
    auto& detail = last["detail"].get_ref<std::string&>();
    if (!detail.empty()) detail += ' ';
    detail += shown;
  }
  return families;
}

Json workspace_symbols(OpenMachines& machines, Json const& params) {
  constexpr std::size_t shortest_name = 2;
  auto const query = params.value("query", std::string());
  auto found = Json::array();
  std::set<std::string> inputs;
  for (auto const& [uri, document] : machines.documents()) inputs.insert(machines.machine_of(document));
  for (auto const& path : inputs) {
    auto const& reading = machines.reading_of(path);
    if (reading.machine() == nullptr) continue;
    auto const add = [&](std::string const& name, SymbolKind kind, std::string const& file) {
      bool const is_wanted =
          std::search(name.begin(), name.end(), query.begin(), query.end(), [](char a, char b) {
            return ascii::equal_ignoring_case({&a, 1}, {&b, 1});
          }) != name.end();
      if (name.empty() || !is_wanted) return;
      found.push_back({{"name", name},
                       {"kind", static_cast<int>(kind)},
                       {"containerName", std::string(validator::file_name(path))},
                       {"location", {{"uri", reading.files().uri(file)}, {"range", range_json({}, {})}}}});
    };
    auto const& machine = *reading.machine();
    for (auto const& axis : machine.axes) {
      add(axis.name, SymbolKind::object, reading.sources()[machine.lists[axis.list].list.source].name());
    }
    for (auto const& group : machine.groups) add(group.name, SymbolKind::property, path);
    if (query.size() < shortest_name || machine.axes.empty()) continue;
    Places const places(reading.sources(), reading.files(), machines.encoding());
    auto const names = meant_parameters(machine.axes.front().merged.values.catalogue(), query);
    for (auto const& axis : machine.axes) {
      for (auto const* const value : axis.merged.values.set_values()) {
        if (!names.contains(value->row->name) || !value->name_place()) continue;
        auto const name = axis.name + ": " + validator::parameter_name(*value);
        // Editors show a symbol only if its name resembles the query.
        bool const has_query = ascii::lower_case(name).find(ascii::lower_case(query)) != std::string::npos;
        found.push_back({{"name", has_query ? name : name + " (" + query + ")"},
                         {"kind", static_cast<int>(SymbolKind::property)},
                         {"containerName", std::string(validator::file_name(path))},
                         {"location", places.location(*value->name_place())}});
      }
    }
  }
  return found;
}

}  // namespace axisc::editor
