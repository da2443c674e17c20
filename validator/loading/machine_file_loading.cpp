#include "configuration/sentences.hpp"
#include "schema/closest_word.hpp"
#include "validator/loading/loader.hpp"
#include "validator/loading/unreadable_file.hpp"
#include "validator/sentences.hpp"

#include <algorithm>
#include <utility>

namespace axisc::validator::says {

constexpr Sentence is_machine{"\"{file}\" is a machine file; machine files do not name one another",
                              "„{file}“ ist eine Maschinendatei; Maschinendateien nennen einander nicht"};

constexpr Sentence no_channel_list{"\"{file}\" is no channel list: its parameters are {kind}",
                                   "„{file}“ ist keine Kanalliste: sie enthält {kind}"};

}  // namespace axisc::validator::says

namespace axisc::validator {

void Loader::load_machine_file(SourceId source) {
  configuration::MachineFile const file =
      configuration::read_machine_file(sources_, source, machine_.findings);
  machine_.machine_file = source;
  machine_.inch = file.inch;
  machine_.report = file.report;
  if (file.machine) machine_.name = file.machine->text;
  machine_.cycle_time = file.cycle_time;
  if (file.default_list) {
    machine_.default_list = list_named(*file.default_list);
    if (machine_.default_list) {
      machine_.lists[*machine_.default_list].list.is_default_list = true;
    } else {
      machine_.findings.back().notes.push_back({says::control_defaults, {}});
    }
    by_path_.clear();
  }
  for (configuration::MachineFileAxis const& named : file.axes) {
    std::optional<std::size_t> const list = list_named(named.list);
    if (!list) continue;
    LoadedAxis& axis = add_axis(*list, named.type);
    axis.name = named.name.text;
    axis.drive = named.drive;
    axis.drive_delay_us = named.drive_delay_us;
    if (named.position_control) {
      axis.position_control = named.position_control->text == "drive" ? machine::PositionController::drive
                                                                      : machine::PositionController::cnc;
    }
  }
  if (file.default_channel_list) {
    machine_.default_channel_list = channel_list_named(*file.default_channel_list);
  }
  for (configuration::MachineFileGroup const& group : file.groups) add_group(group);
  for (configuration::MachineFileGantry const& gantry : file.gantries) add_claims(gantry);
  for (configuration::LocatedText const& name : file.programs) {
    if (auto const program = program_named(name)) common_programs_.push_back(*program);
  }
  machine_.filter_sets = file.filter_sets;
}

std::optional<std::size_t> Loader::axis_named(configuration::LocatedText const& name) const {
  auto const axis = std::find_if(machine_.axes.begin(), machine_.axes.end(),
                                 [&](LoadedAxis const& known) { return known.name == name.text; });
  if (axis == machine_.axes.end()) return std::nullopt;
  return static_cast<std::size_t>(axis - machine_.axes.begin());
}

void Loader::add_group(configuration::MachineFileGroup const& named) {
  LoadedGroup& group = machine_.groups.emplace_back();
  if (named.name) group.name = named.name->text;
  for (configuration::LocatedText const& name : named.axes) {
    std::optional<std::size_t> const axis = axis_named(name);
    if (axis) group.axes.push_back(*axis);
  }
  for (configuration::LocatedText const& name : named.programs) {
    std::optional<std::size_t> const program = program_named(name);
    if (program && !runs_in(group, *program)) group.programs.push_back(*program);
  }
  if (named.channel_list) group.channel_list = channel_list_named(*named.channel_list);
  if (group.channel_list) {
    group.pairs = configuration::read_channel_list(sources_[*group.channel_list], *group.channel_list).pairs;
  }
  configuration::ListedLookAhead look_ahead;
  if (named.look_ahead_blocks) {
    look_ahead.function.emplace().text = "FCT_LOOK_AHEAD_CUSTOM";
    look_ahead.blocks = named.look_ahead_blocks;
  }
  read_dynamics(group, std::move(look_ahead));
  std::sort(group.axes.begin(), group.axes.end());
  group.axes.erase(std::unique(group.axes.begin(), group.axes.end()), group.axes.end());
}

void Loader::add_claims(configuration::MachineFileGantry const& gantry) {
  std::optional<std::size_t> const master = axis_named(gantry.master);
  if (!master) return;
  machine_.gantry_claims.push_back({.axis = *master, .master = std::nullopt, .place = gantry.master.place});
  for (configuration::LocatedText const& name : gantry.slaves) {
    std::optional<std::size_t> const slave = axis_named(name);
    if (!slave || slave == master) continue;
    machine_.gantry_claims.push_back({.axis = *slave, .master = master, .place = name.place});
  }
}

std::optional<std::size_t> Loader::list_named(configuration::LocatedText const& name) {
  std::string const shown(is_absolute(name.text) ? file_name(name.text) : std::string_view(name.text));
  std::string const path = beside(machine_.path, name.text);
  if (is_machine_file(path)) {
    refuse(name, says::is_machine);
    return std::nullopt;
  }
  auto const list = add_list(path, shown);
  if (auto const* const index = std::get_if<std::size_t>(&list)) {
    bool const is_axis_list = machine_.lists[*index].list.kind == configuration::ListKind::axis;
    machine_.complete = machine_.complete && is_axis_list;
    return *index;
  }
  missing(name, std::get<configuration::FileError>(list));
  return std::nullopt;
}

std::optional<SourceId> Loader::channel_list_named(configuration::LocatedText const& name) {
  using configuration::ListKind;
  std::string const path = beside(machine_.path, name.text);
  std::string const key = key_of(path);
  auto known = others_by_path_.find(key);
  if (known == others_by_path_.end()) {
    auto bytes = read_text(path);
    if (auto const* const error = std::get_if<configuration::FileError>(&bytes)) {
      missing(name, *error);
      return std::nullopt;
    }
    machine_.files.push_back(path);
    SourceId const source = add_text(path, std::get<std::string>(std::move(bytes)));
    known = others_by_path_.emplace(key, source).first;
    auto const kind = configuration::decided_kind(sources_[source]).value_or(ListKind::channel);
    if (kind == ListKind::channel) {
      std::string shown(is_absolute(name.text) ? file_name(name.text) : std::string_view(name.text));
      add_other_list(source, kind, std::move(shown));
    }
  }
  auto const kind = configuration::decided_kind(sources_[known->second]).value_or(ListKind::channel);
  if (kind == ListKind::channel) return known->second;
  refuse(name, says::no_channel_list);
  machine_.findings.back().message.arguments.push_back(
      {"kind", std::string(configuration::number_prefix(kind))});
  return std::nullopt;
}

std::optional<std::size_t> Loader::program_named(configuration::LocatedText const& name) {
  std::string const path = beside(machine_.path, name.text);
  if (is_machine_file(path)) {
    refuse(name, says::is_machine);
    return std::nullopt;
  }
  auto const program = add_program(name.text, path);
  if (auto const* const index = std::get_if<std::size_t>(&program)) return *index;
  missing(name, std::get<configuration::FileError>(program));
  return std::nullopt;
}

void Loader::missing(configuration::LocatedText const& name, configuration::FileError error) {
  refuse(name, sentence_of(error));
  if (error != configuration::FileError::not_found) return;
  std::string const path = beside(machine_.path, name.text);
  std::string_view const written = file_name(path);
  std::vector<std::string> const names = files_.names_in(path.substr(0, path.size() - written.size()));
  std::string_view const closest =
      schema::closest_word(written, std::vector<std::string_view>(names.begin(), names.end()));
  if (closest.empty()) return;
  // No fix: the name next to it may be another axis' list.
  machine_.findings.back().help.push_back(
      {configuration::says::json_did_you_mean,
       {{"suggestion", name.text.substr(0, name.text.size() - written.size()) + std::string(closest)}}});
}

void Loader::refuse(configuration::LocatedText const& name, SentenceRef text) {
  machine_.complete = false;
  Finding& finding = machine_.findings.emplace_back();
  finding.code = configuration::machine_file_code;
  finding.place = name.place;
  finding.message = {text, {{"file", name.text}}};
}

}  // namespace axisc::validator
