#include "configuration/list_search.hpp"
#include "configuration/machine_file.hpp"
#include "configuration/start_up_list.hpp"
#include "editor/open_list.hpp"
#include "editor/parameter_number.hpp"
#include "editor/places.hpp"
#include "editor/requests.hpp"
#include "editor/server.hpp"
#include "schema/indexed_name.hpp"
#include "validator/loading/loader.hpp"
#include "validator/views/units_text.hpp"

#include <nlohmann/json.hpp>

namespace axisc::editor {

namespace {

enum class SymbolKind : int { property = 7, object = 19 };

/// The files that a machine file or a start-up list names, where they are found.
struct NamedFile {
  Place place;
  std::string path;
};

std::vector<NamedFile> files_of_machine_file(Buffers& files, SourceSet const& sources, SourceId source) {
  std::deque<Finding> mistakes;
  auto const machine = configuration::read_machine_file(sources, source, mistakes);
  std::vector<NamedFile> named;
  auto const add = [&](configuration::LocatedText const& name) {
    auto path = validator::beside(sources[source].name(), name.text);
    if (files.is_file(path)) named.push_back({.place = name.place, .path = std::move(path)});
  };
  if (machine.default_list) add(*machine.default_list);
  for (auto const& axis : machine.axes) add(axis.list);
  for (auto const& group : machine.groups) {
    for (auto const& program : group.programs) add(program);
  }
  for (auto const& program : machine.programs) add(program);
  return named;
}

std::vector<NamedFile> files_of_start_up_list(Buffers& files, SourceSet const& sources, SourceId source) {
  auto const list = configuration::read_start_up_list(sources[source], source);
  std::vector<NamedFile> named;
  for (auto const* const name : configuration::named_lists(list)) {
    auto found = configuration::find_list(files, sources[source].name(), name->text);
    if (found) named.push_back({.place = name->place, .path = std::move(found->path)});
  }
  return named;
}

std::vector<NamedFile> named_files(Buffers& files, SourceSet& sources, Document const& document) {
  auto const source = sources.add(SourceText(document.path, document.text));
  if (document.path.ends_with(".json")) {
    if (!configuration::looks_like_machine_file(document.text)) return {};
    return files_of_machine_file(files, sources, source);
  }
  bool const is_start_up = is_list(document.path) && configuration::looks_like_start_up_list(document.text);
  return is_start_up ? files_of_start_up_list(files, sources, source) : std::vector<NamedFile>();
}

/// "BANDSTOP 42 Hz" of a filter.
std::string summary(std::string_view key, std::string_view value) {
  if (key == "type") return std::string(value);
  if (key != "fg_f0") return {};
  auto const number = schema::read_real(value);
  return number.status == schema::NumberStatus::good ? validator::physical(number.number, "Hz") : "";
}

}  // namespace

Json Server::links(Json const& params) {
  auto const& asked = document(params);
  Buffers files(documents_, surroundings_.disk);
  SourceSet sources;
  auto links = Json::array();
  Places const places(sources, files, encoding_);
  for (auto const& named : named_files(files, sources, asked)) {
    links.push_back({{"range", places.range(named.place)}, {"target", files.uri(named.path)}});
  }
  return links;
}

Json Server::define(Json const& params) {
  auto const& asked = document(params);
  auto const offset = offset_of(asked.text, position_in(params.at("position")), encoding_);
  auto const is_on = [offset](Span span) { return span.begin <= offset && offset <= span.end; };
  Buffers files(documents_, surroundings_.disk);
  SourceSet sources;
  for (auto const& named : named_files(files, sources, asked)) {
    if (is_on(named.place.span)) return {{"uri", files.uri(named.path)}, {"range", range_json({}, {})}};
  }
  auto found = Json::array();
  if (!is_list(asked.path)) return found;
  OpenList const list(files, asked, machine_of(asked), surroundings_.options);
  Places const places(list.sources(), files, encoding_);
  auto const add = [&](schema::Slot slot) {
    for (auto const& place : list.lines_setting(slot)) found.push_back(places.location(place));
  };
  if (auto const number = parameter_number_at(asked.text, offset)) {
    if (number->kind != list.catalogue().kind()) return found;
    for (auto const id : list.catalogue().find_number(number->number)) {
      auto const& row = list.catalogue().parameter(id);
      for (std::uint32_t i = 0; i < row.slots; ++i) {
        add(static_cast<schema::Slot>(static_cast<std::uint32_t>(row.first_slot) + i));
      }
    }
    return found;
  }
  auto const* const line = list.line_at(offset);
  if (line == nullptr || !is_on(line->name)) return found;
  auto const name = list.find(list.slice(line->name));
  if (name.status == schema::NameLookup::Status::found) add(name.slot);
  return found;
}

Json Server::symbols(Json const& params) {
  auto const& asked = document(params);
  auto families = Json::array();
  if (!is_list(asked.path)) return families;
  SourceText const text(asked.path, asked.text);
  auto const tree = grammar::parse_axis_list(text);
  SourceSet sources;
  auto const source = sources.add(SourceText(asked.path, asked.text));
  Buffers const files(documents_, surroundings_.disk);
  Places const places(sources, files, encoding_);
  for (auto const& line : tree.assignments) {
    auto name = text.slice(line.name);
    auto const family = schema::take_part(name);
    auto const value = text.utf8(line.value);
    auto const range =
        places.range({.source = source, .span = {.begin = line.name.begin, .end = line.value.end}});
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
    auto const said = summary(name, value);
    if (said.empty()) continue;
    auto& detail = last["detail"].get_ref<std::string&>();
    if (!detail.empty()) detail += ' ';
    detail += said;
  }
  return families;
}

}  // namespace axisc::editor
