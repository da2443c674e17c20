#include "editor/capabilities/navigation.hpp"

#include "configuration/list_search.hpp"
#include "configuration/machine_file.hpp"
#include "configuration/start_up_list.hpp"
#include "editor/meaning/named_axes.hpp"
#include "editor/meaning/parameter_number.hpp"
#include "editor/reading/open_machines.hpp"
#include "editor/reading/places.hpp"
#include "validator/loading/loader.hpp"

#include <deque>
#include <utility>

#include <nlohmann/json.hpp>

namespace axisc::editor::says {

constexpr Sentence names_of_the_control{
    "names of parameters belong to the control: they cannot be renamed",
    "Parameternamen gehören zur Steuerung: sie lassen sich nicht umbenennen"};

}  // namespace axisc::editor::says

namespace axisc::editor {

namespace {

/// A file that a machine file or a start-up list names, and that exists.
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
  if (machine.default_channel_list) add(*machine.default_channel_list);
  for (auto const& axis : machine.axes) add(axis.list);
  for (auto const& group : machine.groups) {
    if (group.channel_list) add(*group.channel_list);
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

std::vector<NamedFile> named_files(Buffers& files, SourceSet& sources, OpenDocument const& document) {
  auto const source = sources.add(SourceText(document.path, document.text));
  if (document.path.ends_with(".json")) {
    if (!configuration::looks_like_machine_file(document.text)) return {};
    return files_of_machine_file(files, sources, source);
  }
  bool const is_start_up = is_list(document.path) && configuration::looks_like_start_up_list(document.text);
  return is_start_up ? files_of_start_up_list(files, sources, source) : std::vector<NamedFile>();
}

enum class LinesOf : std::uint8_t { list, machine };

/// The lines that set the parameter at a byte: for the list alone, or in the whole machine.
Json lines_setting(OpenMachines& machines, OpenDocument const& asked, std::size_t offset, LinesOf of) {
  auto found = Json::array();
  auto& reading = machines.reading_of(asked);
  auto const& list = reading.list(asked);
  Places const places(reading.sources(), reading.files(), machines.encoding());
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
  if (line == nullptr || !touches(line->name, offset)) return found;
  auto const name = list.find(list.slice(line->name));
  if (name.status == schema::NameLookup::Status::found) add(name.slot);
  return found;
}

Json whole_file(std::string const& uri) {
  return {{"uri", uri}, {"range", range_json({}, {})}};
}

}  // namespace

Json links(OpenMachines& machines, Json const& params) {
  auto const& asked = machines.asked(params);
  auto files = machines.buffers();
  SourceSet sources;
  auto found = Json::array();
  Places const places(sources, files, machines.encoding());
  for (auto const& named : named_files(files, sources, asked)) {
    found.push_back({{"range", places.range(named.place)}, {"target", files.uri(named.path)}});
  }
  return found;
}

Json define(OpenMachines& machines, Json const& params) {
  auto const& asked = machines.asked(params);
  auto const offset = machines.offset(asked, params);
  auto files = machines.buffers();
  SourceSet sources;
  for (auto const& named : named_files(files, sources, asked)) {
    if (touches(named.place.span, offset)) return whole_file(files.uri(named.path));
  }
  if (auto const list = list_of_named_axis(machines.reading_of(asked), asked, offset)) {
    return whole_file(files.uri(*list));
  }
  return is_list(asked.path) ? lines_setting(machines, asked, offset, LinesOf::list) : Json::array();
}

Json refer(OpenMachines& machines, Json const& params) {
  auto const& asked = machines.asked(params);
  if (!is_list(asked.path)) return Json::array();
  return lines_setting(machines, asked, machines.offset(asked, params), LinesOf::machine);
}

Json refuse_renaming(OpenMachines& machines, Json const& /*params*/) {
  throw RequestRefused(machines.say(says::names_of_the_control));
}

}  // namespace axisc::editor
