#include "validator/loading/loader.hpp"

#include "configuration/machine_file_name.hpp"
#include "configuration/real_time_list.hpp"
#include "configuration/xml/xml_list.hpp"
#include "configuration/xml/xml_names.hpp"
#include "diagnostics/ascii.hpp"
#include "grammar/axis_list.hpp"
#include "system/path.hpp"
#include "validator/commands/command_check.hpp"
#include "validator/values/kind_of_list.hpp"
#include "validator/values/list_reader.hpp"

#include <algorithm>
#include <filesystem>
#include <tuple>
#include <utility>

namespace axisc::validator {
namespace {

using configuration::ListKind;

constexpr std::string_view separators = "/\\";

bool is_machine_text(std::string_view path, std::string_view text) {
  if (!ascii::has_extension(path, ".json")) return false;
  bool const is_blank = text.find_first_not_of(" \t\r\n") == std::string_view::npos;
  return is_blank || configuration::is_machine_file_name(path) ||
         configuration::looks_like_machine_file(text);
}

/// Numbers the lines as in the file that contains the list.
void number_lines(SourceText const& text, grammar::AxisList& tree) {
  for (grammar::Assignment& line : tree.assignments) line.line = text.position(line.name.begin).line;
  for (grammar::Problem& problem : tree.problems) problem.line = text.position(problem.span.begin).line;
}

LoadedList loaded(SourceText const& text, SourceId source, schema::Catalogue const& catalogue,
                  ReadList read) {
  LoadedList list;
  list.source = source;
  list.catalogue = catalogue;
  list.tree = std::move(read.tree);
  list.line_values = std::move(read.line_values);
  if (text.is_translation()) number_lines(text, list.tree);
  list.lost = lost_assignments(text, list.tree, list.line_values, catalogue);
  return list;
}

/// A list where an axis list is expected.
LoadedList parse(SourceSet const& sources, SourceId source, schema::Catalogue const& catalogue) {
  SourceText const& text = sources[source];
  ReadList read = read_list(text, catalogue);
  ListKind const kind = kind_of_list(text, read.tree, read.line_values).value_or(ListKind::axis);
  if (kind != ListKind::axis) read = judge_list(text, {}, catalogue);
  LoadedList list = loaded(text, source, catalogue, std::move(read));
  list.kind = kind;
  return list;
}

LoadedList parse_other(SourceSet const& sources, SourceId source, ListKind kind,
                       schema::Catalogue const& axis_catalogue) {
  SourceText const& text = sources[source];
  schema::Catalogue const catalogue = kind == ListKind::axis ? axis_catalogue : schema::Catalogue::of(kind);
  LoadedList list = loaded(text, source, catalogue, read_list(text, catalogue));
  list.kind = kind;
  return list;
}

}  // namespace

std::string_view file_name(std::string_view path) {
  std::size_t const separator = path.find_last_of(separators);
  return separator == std::string_view::npos ? path : path.substr(separator + 1);
}

std::string_view without_extension(std::string_view name) {
  std::size_t const point = name.find_last_of('.');
  return point == std::string_view::npos || point == 0 ? name : name.substr(0, point);
}

bool is_absolute(std::string_view path) {
  bool const drive = path.size() > 1 && path[1] == ':';
  return drive || (!path.empty() && separators.find(path.front()) != std::string_view::npos);
}

std::string beside(std::string const& path, std::string const& name) {
  if (is_absolute(name)) return name;
  return path.substr(0, path.size() - file_name(path).size()) + name;
}

std::string key_of(std::string const& path) {
  return system::name_of(system::path_of(path).lexically_normal());
}

bool runs_in(LoadedGroup const& group, std::size_t program) {
  return std::find(group.programs.begin(), group.programs.end(), program) != group.programs.end();
}

std::optional<configuration::FileError> Loader::load(std::string const& path) {
  machine_.path = path;
  machine_.name = without_extension(file_name(path));
  machine_.files.push_back(path);
  if (auto const error = ascii::has_extension(path, ".nc") ? load_program() : load_text()) return *error;
  if (machine_.groups.empty()) add_default_group();
  for (LoadedGroup& group : machine_.groups) {
    for (std::size_t const program : common_programs_) {
      if (!runs_in(group, program)) group.programs.push_back(program);
    }
  }
  if (options_.cycle_time) machine_.cycle_time = options_.cycle_time;
  if (!machine_.cycle_time) machine_.cycle_time = options_.cycle_time_otherwise;
  machine_.build = options_.build;
  machine_.readings = options_.readings;
  machine_.motion = options_.motion;
  machine_.is_beside_start_up_list = options_.is_beside_start_up_list;
  return std::nullopt;
}

std::optional<configuration::FileError> Loader::load_program() {
  auto const program = add_program(std::string(file_name(machine_.path)), machine_.path);
  if (auto const* const error = std::get_if<configuration::FileError>(&program)) return *error;
  return std::nullopt;
}

std::optional<configuration::FileError> Loader::load_text() {
  std::variant<std::string, configuration::FileError> bytes = read_text(machine_.path);
  if (auto const* const error = std::get_if<configuration::FileError>(&bytes)) return *error;
  auto& text = std::get<std::string>(bytes);
  bool const is_machine = machine_.path == "-" ? configuration::looks_like_machine_file(text)
                                               : is_machine_text(machine_.path, text);
  bool const is_project = !is_machine && configuration::is_project_name(machine_.path);
  auto const xml_kind = configuration::xml_list_kind(text);
  bool const may_be_start_up =
      !is_machine && !is_project && (!options_.kind || options_.kind == ListKind::startup);
  bool const is_start_up = xml_kind ? xml_kind == ListKind::startup
                                    : may_be_start_up && configuration::looks_like_start_up_list(text);
  SourceId const source = add_text(machine_.path, std::move(text));
  if (is_machine) {
    load_machine_file(source);
  } else if (is_project) {
    load_project(source);
  } else if (is_start_up) {
    load_start_up_list(source);
  } else if (xml_kind.has_value()) {
    // It holds only changes, so nothing else is judged.
    load_single_other(source, *xml_kind);
  } else if (!sources_[source].is_translation()) {
    load_single(source);
  }
  return std::nullopt;
}

bool Loader::is_machine_file(std::string const& path) {
  if (!ascii::has_extension(path, ".json")) return false;
  auto const bytes = files_.read(path);
  auto const* const text = std::get_if<std::string>(&bytes);
  return text != nullptr && is_machine_text(path, *text);
}

void Loader::load_single(SourceId source) {
  SourceText const& text = sources_[source];
  bool const is_axis_list = !options_.kind || options_.kind == ListKind::axis;
  std::optional<ListKind> kind = options_.kind;
  if (is_axis_list) {
    ReadList read = read_list(text, options_.catalogue);
    if (!kind) kind = kind_of_list(text, read.tree, read.line_values);
    // If lines cannot be read, their comments may still tell the kind.
    if (!kind && options_.from_folder) kind = configuration::kind_numbered_in(text.list_bytes());
    if (!kind && !options_.from_folder) kind = ListKind::axis;
    if (kind == ListKind::axis) {
      machine_.lists.push_back({.name = std::string(file_name(machine_.path)),
                                .list = loaded(text, source, options_.catalogue, std::move(read))});
    }
  }
  if (!kind) machine_.list_of_unknown_kind = source;
  if (kind && kind != ListKind::axis) load_single_other(source, *kind);
  if (machine_.lists.empty()) return;
  LoadedAxis& axis = add_axis(0, std::nullopt);
  EffectiveValue const& name = axis.merged.values.at("kopf.log_achs_name");
  bool const named = name.set() && !name.unusable && !name.value.text.empty();
  axis.name = named ? std::string(name.value.text) : machine_.name;
  machine_.name = axis.name;
}

void Loader::load_single_other(SourceId source, ListKind kind) {
  add_other_list(source, kind, std::string(file_name(machine_.path)));
  // What it says of the cycle time is judged; the cycle time is that of a machine.
  if (kind == ListKind::real_time) {
    std::ignore = configuration::read_real_time_list(sources_[source], source, machine_.findings);
  }
}

void Loader::add_other_list(SourceId source, ListKind kind, std::string name) {
  machine_.other_lists.push_back(
      {.name = std::move(name), .list = parse_other(sources_, source, kind, options_.catalogue)});
}

/// None instead of channels whose lists are named but not read.
void Loader::add_default_group() {
  if (machine_.start_up && !machine_.start_up->list.channels.empty()) return;
  LoadedGroup group;
  for (std::size_t axis = 0; axis < machine_.axes.size(); ++axis) {
    if (machine_.axes[axis].type != machine::AxisType::spindle) group.axes.push_back(axis);
  }
  read_dynamics(group, {});
  if (!group.axes.empty()) machine_.groups.push_back(std::move(group));
}

void Loader::read_dynamics(LoadedGroup& group, configuration::ListedLookAhead look_ahead) {
  configuration::ListedDynamics listed;
  group.look_ahead_said = look_ahead.function.has_value();
  listed.look_ahead = std::move(look_ahead);
  for (std::optional<SourceId> const source : {machine_.default_channel_list, group.channel_list}) {
    if (!source) continue;
    configuration::read_channel_dynamics(configuration::listed_values(sources_[*source], *source), listed);
  }
  bool const is_older = options_.build && *options_.build < builds::longer_look_ahead;
  constexpr std::uint32_t blocks_of_older = 70;
  group.dynamics = listed.dynamics;
  group.dynamics.look_ahead_blocks = configuration::look_ahead_blocks(
      listed.look_ahead, listed.dynamics.slope,
      is_older ? blocks_of_older : machine::ChannelDynamics{}.look_ahead_blocks);
  group.uncomputed = std::move(listed.uncomputed);
  group.slope_place = listed.slope_place;
}

LoadedAxis& Loader::add_axis(std::size_t list, std::optional<machine::AxisType> type) {
  if (options_.axis_type) type = options_.axis_type;
  std::optional<bool> rotary;
  if (type) rotary = *type != machine::AxisType::translatory;
  MergedValues merged = merge_lists(machine_.list_of_defaults(), machine_.lists[list].list, rotary);
  merged.values.read_as(options_.readings);
  machine::AxisType const known_type = type.value_or(axis_type_of(merged.values));
  machine_.axes.push_back(
      {.name = {}, .type = known_type, .list = list, .drive = {}, .merged = std::move(merged)});
  return machine_.axes.back();
}

std::variant<std::string, configuration::FileError> Loader::read_text(std::string const& path) {
  std::variant<std::string, configuration::FileError> bytes = files_.read(path);
  if (auto const* const text = std::get_if<std::string>(&bytes)) {
    std::variant<std::monostate, configuration::FileError> const problem = configuration::check_text(*text);
    if (auto const* const error = std::get_if<configuration::FileError>(&problem)) return *error;
  }
  return bytes;
}

SourceId Loader::add_text(std::string const& path, std::string bytes) {
  std::vector<configuration::XmlMistake> mistakes;
  SourceId const source = sources_.add(configuration::list_text(path, std::move(bytes), mistakes));
  for (configuration::XmlMistake& mistake : mistakes) {
    machine_.complete = false;
    Finding& finding = machine_.findings.emplace_back();
    finding.code = configuration::machine_file_code;
    finding.place = Place{.source = source, .span = mistake.span};
    finding.message = std::move(mistake.message);
  }
  return source;
}

std::variant<std::size_t, configuration::FileError> Loader::add_list(std::string const& path,
                                                                     std::string shown) {
  std::string const key = key_of(path);
  auto const known = by_path_.find(key);
  if (known != by_path_.end()) return known->second;
  std::variant<std::string, configuration::FileError> bytes = read_text(path);
  if (auto const* const error = std::get_if<configuration::FileError>(&bytes)) return *error;
  machine_.files.push_back(path);
  SourceId const source = add_text(path, std::move(std::get<std::string>(bytes)));
  std::size_t const list = add_source(source, std::move(shown));
  by_path_.emplace(key, list);
  return list;
}

std::size_t Loader::add_source(SourceId source, std::string shown) {
  machine_.lists.push_back({.name = std::move(shown), .list = parse(sources_, source, options_.catalogue)});
  return machine_.lists.size() - 1;
}

std::variant<std::size_t, configuration::FileError> Loader::add_program(std::string name,
                                                                        std::string const& path) {
  std::string const key = key_of(path);
  auto const known = programs_by_path_.find(key);
  if (known != programs_by_path_.end()) return known->second;
  std::variant<ReadProgram, configuration::FileError> read =
      read_program(files_, path, options_.whole_programs ? ProgramText::whole : ProgramText::excerpt);
  if (auto const* const error = std::get_if<configuration::FileError>(&read)) return *error;
  auto& content = std::get<ReadProgram>(read);
  LoadedProgram program;
  program.name = std::move(name);
  program.path = path;
  program.mark = content.mark;
  program.source = sources_.add(std::move(content.text));
  program.tree = std::move(content.tree);
  std::string_view const text = sources_[program.source].bytes();
  program.gives_order =
      std::any_of(program.tree.commands.begin(), program.tree.commands.end(),
                  [&](grammar::NcCommand const& command) { return gives_order(command, text); });
  machine_.programs.push_back(std::move(program));
  if (path != machine_.path) machine_.files.push_back(path);
  programs_by_path_.emplace(key, machine_.programs.size() - 1);
  return machine_.programs.size() - 1;
}

}  // namespace axisc::validator
