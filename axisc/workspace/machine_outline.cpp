#include "axisc/workspace/machine_outline.hpp"

#include "axisc/files/disk_files.hpp"
#include "configuration/channel_list.hpp"
#include "configuration/list_search.hpp"
#include "configuration/located_json.hpp"
#include "configuration/machine_file_name.hpp"
#include "configuration/project_file.hpp"
#include "configuration/start_up_list.hpp"
#include "configuration/xml/xml_list.hpp"
#include "configuration/xml/xml_names.hpp"
#include "diagnostics/ascii.hpp"
#include "system/path.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <variant>

#include <nlohmann/json.hpp>

namespace axisc {

namespace {

namespace fs = std::filesystem;
using json_type = nlohmann::json;

/// With `/`, as the machine file's reader gives it.
std::string file_named(json_type const& text) {
  auto name = text.get<std::string>();
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

void add_list(std::vector<std::string>& named, json_type const& object, char const* key) {
  if (!object.is_object()) return;
  auto const found = object.find(key);
  if (found != object.end() && found->is_string()) named.push_back(file_named(*found));
}

void add_programs(std::vector<std::string>& named, json_type const& object) {
  if (!object.is_object()) return;
  auto const found = object.find("programs");
  if (found == object.end() || !found->is_array()) return;
  for (auto const& program : *found) {
    if (program.is_string()) named.push_back(file_named(program));
  }
}

std::string relative_to(fs::path const& folder, std::string const& path) {
  auto const relative = system::path_of(path).lexically_relative(folder.empty() ? "." : folder);
  return system::name_of(relative.empty() ? fs::absolute(system::path_of(path)) : relative);
}

void add_found_programs(MachineOutline& outline, DiskFiles& files, std::string const& path,
                        configuration::ChannelList const& channel) {
  auto const folder = system::path_of(path).parent_path();
  for (auto const& program : configuration::found_programs(files, path, channel)) {
    outline.programs.push_back(relative_to(folder, program));
  }
}

SourceText list_text(std::string const& path, std::string text) {
  // The check reports what is wrong with it.
  std::vector<configuration::XmlMistake> mistakes;
  return configuration::list_text(path, std::move(text), mistakes);
}

std::optional<configuration::ChannelList> channel_list(DiskFiles& files, std::string const& start_up,
                                                       configuration::LocatedText const& named) {
  auto const found = configuration::find_list(files, start_up, named.text);
  auto bytes = found ? files.read(found->path) : configuration::FileError::not_found;
  if (!std::holds_alternative<std::string>(bytes)) return std::nullopt;
  return configuration::read_channel_list(list_text(found->path, std::get<std::string>(std::move(bytes))),
                                          SourceId{});
}

/// The lists and programs that are found.
MachineOutline start_up_outline(DiskFiles& files, std::string const& path, std::string text) {
  MachineOutline outline{.is_machine = true};
  auto const folder = system::path_of(path).parent_path();
  auto const start_up = configuration::read_start_up_list(list_text(path, std::move(text)), SourceId{});
  for (auto const* const named : configuration::named_lists(start_up)) {
    outline.written.push_back(named->text);
    auto const found = configuration::find_list(files, path, named->text);
    if (found) outline.lists.push_back(relative_to(folder, found->path));
  }
  std::optional<configuration::ChannelList> defaults;
  if (start_up.default_channel) defaults = channel_list(files, path, *start_up.default_channel);
  for (auto const& entry : start_up.channels) {
    auto channel = channel_list(files, path, entry.file);
    if (!channel) continue;
    if (defaults) configuration::add_default_programs(*channel, *defaults);
    add_found_programs(outline, files, path, *channel);
  }
  return outline;
}

/// ASCII text in UTF-16, decoded; any other text unchanged.
std::string narrowed(std::string text) {
  if (configuration::check_beginning(text) != configuration::FileError::utf16) return text;
  std::erase(text, '\0');
  auto const first = text.find_first_not_of("\xFF\xFE");
  return text.substr(std::min(first, text.size()));
}

/// JSON that breaks off, also inside a token; a comma before the last bracket is another mistake.
bool ends_early(std::string_view json) {
  auto const parsed = configuration::parse_json(json, 0);
  auto const* const error = std::get_if<configuration::JsonError>(&parsed);
  if (error == nullptr || error->span.empty()) return error != nullptr;
  std::string_view const word = json.substr(error->span.begin, error->span.size());
  return error->span.end >= json.size() && word != "}" && word != "]";
}

bool is_text(std::string_view bytes) {
  return !configuration::check_beginning(bytes);
}

MachineOutline xml_outline(DiskFiles& files, std::string const& path, std::string text) {
  bool const is_readable = is_text(text);
  if (!is_readable) text = narrowed(std::move(text));
  bool const is_start_up = configuration::xml_list_kind(text) == configuration::ListKind::startup;
  if (!is_readable || !is_start_up) {
    return {.is_machine = is_start_up, .is_xml_list = configuration::may_be_xml_list(text)};
  }
  auto outline = start_up_outline(files, path, std::move(text));
  outline.is_xml_list = true;
  return outline;
}

/// A project holds its lists itself.
MachineOutline project_outline(DiskFiles& files, std::string const& path, std::string text) {
  if (!is_text(text)) return {.is_machine = true};
  SourceSet sources;
  SourceId const source = sources.add(SourceText(path, std::move(text)));
  std::deque<Finding> mistakes;
  auto const project = configuration::read_project(sources, source, mistakes);
  MachineOutline outline{.is_machine = project.is_of_cnc};
  for (auto const& list : project.lists) {
    if (list.kind != configuration::ListKind::channel) continue;
    SourceText const text_of_list(path, Window{.file = sources[source], .span = list.span});
    add_found_programs(outline, files, path, configuration::read_channel_list(text_of_list, SourceId{}));
  }
  return outline;
}

MachineOutline json_outline(std::string const& path, std::string text) {
  bool const is_named = configuration::is_machine_file_name(path);
  if (is_text(text)) {
    auto outline = read_machine_outline(text);
    outline.is_machine = outline.is_machine || is_named;
    return outline;
  }
  // Its lists are not read through it, so it names none.
  bool const is_utf16 = configuration::check_beginning(text) == configuration::FileError::utf16;
  auto const outline = read_machine_outline(narrowed(std::move(text)));
  return {.is_machine = is_named || outline.is_machine, .is_unclear = !is_utf16 || outline.is_unclear};
}

bool may_be_start_up_list(DiskFiles& files, std::string const& path) {
  bool is_start_up = false;
  bool const failed = files
                          .read_pieces(path,
                                       [&](std::string_view beginning) {
                                         is_start_up = configuration::looks_like_start_up_list(beginning);
                                         return false;
                                       })
                          .has_value();
  return !failed && is_start_up;
}

}  // namespace

MachineOutline outline_of(std::string const& path) {
  DiskFiles files;
  bool const is_json = ascii::has_extension(path, ".json");
  bool const is_project = configuration::is_project_name(path);
  bool const is_xml = configuration::is_xml_name(path);
  if (!is_json && !is_project && !is_xml &&
      (path == "-" || ascii::has_extension(path, ".nc") || !may_be_start_up_list(files, path))) {
    return {};
  }
  auto bytes = files.read(path);
  if (!std::holds_alternative<std::string>(bytes)) {
    return {.is_machine = is_json || is_project, .is_xml_list = is_xml};
  }
  auto& text = std::get<std::string>(bytes);
  if (is_project) return project_outline(files, path, std::move(text));
  if (is_xml) return xml_outline(files, path, std::move(text));
  return is_json ? json_outline(path, std::move(text)) : start_up_outline(files, path, std::move(text));
}

MachineOutline read_machine_outline(std::string_view json) {
  auto const document = json_type::parse(json.begin(), json.end(), nullptr, false);
  if (document.is_discarded()) {
    // A malformed machine file still counts as one: its mistake becomes a finding.
    return {.is_machine = json.find("\"axes\"") != std::string_view::npos, .is_unclear = ends_early(json)};
  }
  MachineOutline outline;
  if (!document.is_object() || !document.contains("axes")) return outline;
  outline.is_machine = true;
  add_list(outline.lists, document, "default_list");
  add_list(outline.lists, document, "default_channel_list");
  for (auto const& axis : document["axes"]) add_list(outline.lists, axis, "list");
  add_programs(outline.programs, document);
  if (document.contains("groups")) {
    for (auto const& group : document["groups"]) {
      add_list(outline.lists, group, "channel_list");
      add_programs(outline.programs, group);
    }
  }
  return outline;
}

}  // namespace axisc
