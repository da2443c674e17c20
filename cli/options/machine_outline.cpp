#include "cli/options/machine_outline.hpp"

#include "cli/files/disk_files.hpp"
#include "configuration/channel_list.hpp"
#include "configuration/list_search.hpp"
#include "configuration/project_file.hpp"
#include "configuration/start_up_list.hpp"
#include "configuration/xml_list.hpp"
#include "diagnostics/ascii.hpp"
#include "system/path.hpp"

#include <algorithm>
#include <filesystem>
#include <variant>

#include <nlohmann/json.hpp>

namespace axisc::cli {

namespace {

namespace fs = std::filesystem;
using json_type = nlohmann::json;

void add_list(std::vector<std::string>& named, json_type const& object, char const* key) {
  if (!object.is_object()) return;
  auto const found = object.find(key);
  if (found != object.end() && found->is_string()) named.push_back(found->get<std::string>());
}

void add_programs(std::vector<std::string>& named, json_type const& object) {
  if (!object.is_object()) return;
  auto const found = object.find("programs");
  if (found == object.end() || !found->is_array()) return;
  for (auto const& program : *found) {
    if (program.is_string()) named.push_back(program.get<std::string>());
  }
}

std::string relative_to(fs::path const& folder, std::string const& path) {
  auto const relative = system::path_of(path).lexically_relative(folder.empty() ? "." : folder);
  return system::name_of(relative.empty() ? fs::absolute(system::path_of(path)) : relative);
}

void add_found_programs(MachineOutline& outline, DiskFiles& files, std::string const& path,
                        SourceText const& channel) {
  auto const folder = system::path_of(path).parent_path();
  for (auto const& program :
       configuration::found_programs(files, path, configuration::read_channel_list(channel, SourceId{}))) {
    outline.programs.push_back(relative_to(folder, program));
  }
}

SourceText list_text(std::string const& path, std::string text) {
  // The check says what is wrong with it.
  std::optional<configuration::XmlMistake> mistake;
  return configuration::list_text(path, std::move(text), mistake);
}

/// The lists and programs that are found.
MachineOutline start_up_outline(DiskFiles& files, std::string const& path, std::string text) {
  MachineOutline outline{.is_machine = true};
  auto const folder = system::path_of(path).parent_path();
  auto const start_up = configuration::read_start_up_list(list_text(path, std::move(text)), SourceId{});
  for (auto const* const named : configuration::named_lists(start_up)) {
    auto const found = configuration::find_list(files, path, named->text);
    if (found) outline.lists.push_back(relative_to(folder, found->path));
  }
  for (auto const& channel : start_up.channels) {
    auto const found = configuration::find_list(files, path, channel.file.text);
    auto bytes = found ? files.read(found->path) : configuration::FileError::not_found;
    if (!std::holds_alternative<std::string>(bytes)) continue;
    add_found_programs(outline, files, path, list_text(found->path, std::get<std::string>(std::move(bytes))));
  }
  return outline;
}

MachineOutline xml_outline(DiskFiles& files, std::string const& path, std::string text) {
  auto const kind = configuration::xml_list_kind(text);
  if (kind != configuration::ListKind::startup) return {.is_xml_list = kind.has_value()};
  auto outline = start_up_outline(files, path, std::move(text));
  outline.is_xml_list = true;
  return outline;
}

/// A project holds its lists itself.
MachineOutline project_outline(DiskFiles& files, std::string const& path, std::string text) {
  if (!configuration::looks_like_project(text)) return {};
  SourceSet sources;
  SourceId const source = sources.add(SourceText(path, std::move(text)));
  std::deque<Finding> mistakes;
  auto const project = configuration::read_project(sources, source, mistakes);
  MachineOutline outline{.is_machine = true};
  for (auto const& list : project.lists) {
    if (list.kind != configuration::ListKind::channel) continue;
    SourceText const text_of_list(path, Window{.file = sources[source].file(), .span = list.span});
    add_found_programs(outline, files, path, text_of_list);
  }
  return outline;
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
  bool const is_json = has_extension(path, ".json");
  bool const is_project = configuration::is_project_name(path);
  bool const is_xml = configuration::is_xml_name(path);
  if (!is_json && !is_project && !is_xml &&
      (path == "-" || has_extension(path, ".nc") || !may_be_start_up_list(files, path))) {
    return {};
  }
  auto bytes = files.read(path);
  if (!std::holds_alternative<std::string>(bytes)) return {.is_machine = is_json};
  auto& text = std::get<std::string>(bytes);
  if (is_project) return project_outline(files, path, std::move(text));
  if (is_xml) return xml_outline(files, path, std::move(text));
  return is_json ? read_machine_outline(text) : start_up_outline(files, path, std::move(text));
}

MachineOutline read_machine_outline(std::string_view json) {
  auto const document = json_type::parse(json.begin(), json.end(), nullptr, false);
  if (document.is_discarded()) {
    // A malformed machine file still counts as one: its mistake becomes a finding.
    return {.is_machine = json.find("\"axes\"") != std::string_view::npos};
  }
  MachineOutline outline;
  if (!document.is_object() || !document.contains("axes")) return outline;
  outline.is_machine = true;
  add_list(outline.lists, document, "default_list");
  for (auto const& axis : document["axes"]) add_list(outline.lists, axis, "list");
  add_programs(outline.programs, document);
  if (document.contains("groups")) {
    for (auto const& group : document["groups"]) add_programs(outline.programs, group);
  }
  return outline;
}

bool has_extension(std::string_view path, std::string_view extension) {
  if (path.size() <= extension.size()) return false;
  return ascii::equal_ignoring_case(path.substr(path.size() - extension.size()), extension);
}

}  // namespace axisc::cli
