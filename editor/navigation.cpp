#include "configuration/list_search.hpp"
#include "configuration/machine_file.hpp"
#include "configuration/start_up_list.hpp"
#include "diagnostics/ascii.hpp"
#include "editor/meaning/named_axes.hpp"
#include "editor/meaning/parameter_number.hpp"
#include "editor/reading/open_list.hpp"
#include "editor/reading/places.hpp"
#include "editor/reading/requests.hpp"
#include "editor/server.hpp"
#include "schema/indexed_name.hpp"
#include "validator/loading/loader.hpp"
#include "validator/views/units_text.hpp"

#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

namespace axisc::editor::says {

constexpr Sentence names_of_the_control{
    "names of parameters belong to the control: they cannot be renamed",
    "Parameternamen gehören zur Steuerung: sie lassen sich nicht umbenennen"};

}  // namespace axisc::editor::says

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
std::string summary(std::string_view key, std::string_view value, Language language) {
  if (key == "type") return std::string(value);
  if (key != "fg_f0") return {};
  auto const number = schema::read_real(value);
  return number.status == schema::NumberStatus::good ? validator::physical(number.number, "Hz").in(language)
                                                     : "";
}

}  // namespace

Json Server::links(Json const& params) {
  auto const& asked = document(params);
  auto files = buffers();
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
  auto files = buffers();
  SourceSet sources;
  for (auto const& named : named_files(files, sources, asked)) {
    if (is_on(named.place.span)) return {{"uri", files.uri(named.path)}, {"range", range_json({}, {})}};
  }
  if (auto const list = list_of_named_axis(reading_of(asked), asked, offset)) {
    return {{"uri", files.uri(*list)}, {"range", range_json({}, {})}};
  }
  return is_list(asked.path) ? lines_setting(asked, offset, LinesOf::list) : Json::array();
}

Json Server::refer(Json const& params) {
  auto const& asked = document(params);
  if (!is_list(asked.path)) return Json::array();
  auto const offset = offset_of(asked.text, position_in(params.at("position")), encoding_);
  return lines_setting(asked, offset, LinesOf::machine);
}

// A row of the table holds a member. NOLINTNEXTLINE(readability-make-member-function-const)
Json Server::refuse_renaming(Json const& /*params*/) {
  throw RequestRefused(
      render({.sentence = says::names_of_the_control, .arguments = {}}, surroundings_.language));
}

Json Server::lines_setting(Document const& asked, std::size_t offset, LinesOf of) {
  auto found = Json::array();
  auto& reading = reading_of(asked);
  auto const& list = reading.list(asked);
  auto const is_on = [offset](Span span) { return span.begin <= offset && offset <= span.end; };
  Places const places(reading.sources(), reading.files(), encoding_);
  auto const add = [&](schema::Slot slot) {
    auto const lines =
        of == LinesOf::machine ? list.lines_setting_in_machine(slot) : list.lines_setting(slot);
    for (auto const& place : lines) found.push_back(places.location(place));
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
  TextLines const lines(asked.text, encoding_);
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
    auto const said = summary(name, value, surroundings_.language);
    if (said.empty()) continue;
    auto& detail = last["detail"].get_ref<std::string&>();
    if (!detail.empty()) detail += ' ';
    detail += said;
  }
  return families;
}

/// Axes and channels of the machines of open documents.
Json Server::workspace_symbols(Json const& params) {
  auto const query = params.value("query", std::string());
  auto found = Json::array();
  std::set<std::string> machines;
  for (auto const& [uri, document] : documents_) machines.insert(machine_of(document));
  for (auto const& path : machines) {
    auto const& reading = reading_of(path);
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
  }
  return found;
}

}  // namespace axisc::editor
