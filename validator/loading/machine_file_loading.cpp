#include "validator/loading/loader.hpp"

#include <algorithm>
#include <utility>

namespace axisc::validator::says {

constexpr Sentence not_found{"the file \"{file}\" does not exist", "die Datei „{file}“ gibt es nicht"};
constexpr Sentence is_folder{"\"{file}\" is a folder", "„{file}“ ist ein Ordner"};
constexpr Sentence no_permission{"access to the file \"{file}\" is denied",
                                 "der Zugriff auf die Datei „{file}“ ist verweigert"};
constexpr Sentence not_readable{"the file \"{file}\" cannot be read", "die Datei „{file}“ ist nicht lesbar"};
constexpr Sentence too_large{"the file \"{file}\" is larger than 1 GiB",
                             "die Datei „{file}“ ist größer als 1 GiB"};
constexpr Sentence line_too_long{"the file \"{file}\" has a line of more than 1 MiB",
                                 "die Datei „{file}“ hat eine Zeile von mehr als 1 MiB"};
constexpr Sentence binary{"the file \"{file}\" is not a text file", "die Datei „{file}“ ist keine Textdatei"};
constexpr Sentence utf16{"the file \"{file}\" is UTF-16; lists are UTF-8 or windows-1252",
                         "die Datei „{file}“ ist UTF-16; Listen sind UTF-8 oder windows-1252"};
constexpr Sentence not_regular{"\"{file}\" is not a regular file", "„{file}“ ist keine gewöhnliche Datei"};
constexpr Sentence link_loop{"the symbolic links of \"{file}\" lead in a circle",
                             "die symbolischen Links von „{file}“ führen im Kreis"};
constexpr Sentence is_machine{"\"{file}\" is a machine file; machine files do not name one another",
                              "„{file}“ ist eine Maschinendatei; Maschinendateien nennen einander nicht"};
constexpr Sentence image{"the file \"{file}\" is a coefficient image, not a list",
                         "die Datei „{file}“ ist ein Koeffizientenabbild, keine Liste"};

}  // namespace axisc::validator::says

namespace axisc::validator {
namespace {

SentenceRef text_of(configuration::FileError error) {
  switch (error) {
    case configuration::FileError::not_found:
      return says::not_found;
    case configuration::FileError::is_folder:
      return says::is_folder;
    case configuration::FileError::no_permission:
      return says::no_permission;
    case configuration::FileError::not_readable:
      return says::not_readable;
    case configuration::FileError::too_large:
      return says::too_large;
    case configuration::FileError::line_too_long:
      return says::line_too_long;
    case configuration::FileError::binary:
      return says::binary;
    case configuration::FileError::utf16:
      return says::utf16;
    case configuration::FileError::image:
      return says::image;
    case configuration::FileError::not_regular:
      return says::not_regular;
    case configuration::FileError::link_loop:
      return says::link_loop;
  }
  return says::not_readable;
}

}  // namespace

void Loader::load_machine_file(SourceId source) {
  configuration::MachineFile const file =
      configuration::read_machine_file(sources_, source, machine_.findings);
  machine_.machine_file = source;
  machine_.inch = file.inch;
  if (file.machine) machine_.name = file.machine->text;
  machine_.cycle_time = file.cycle_time;
  if (file.default_list) {
    machine_.default_list = list_named(*file.default_list);
    machine_.default_list_missing = !machine_.default_list;
    if (machine_.default_list) machine_.lists[*machine_.default_list].list.is_default_list = true;
    by_path_.clear();
  }
  for (configuration::MachineFileAxis const& named : file.axes) {
    std::optional<std::size_t> const list = list_named(named.list);
    if (!list) continue;
    LoadedAxis& axis = add_axis(*list, named.type);
    axis.name = named.name.text;
    axis.drive = named.drive;
    if (named.position_control) {
      axis.position_control = named.position_control->text == "drive" ? machine::PositionController::drive
                                                                      : machine::PositionController::cnc;
    }
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
  if (auto const* const index = std::get_if<std::size_t>(&list)) return *index;
  missing(name, std::get<configuration::FileError>(list));
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
  refuse(name, text_of(error));
}

void Loader::refuse(configuration::LocatedText const& name, SentenceRef text) {
  machine_.complete = false;
  Finding& finding = machine_.findings.emplace_back();
  finding.code = configuration::machine_file_code;
  finding.place = name.place;
  finding.message = {.sentence = text, .arguments = {{"file", name.text}}};
}

}  // namespace axisc::validator
