#include "validator/loading/loading.hpp"

#include "diagnostics/ascii.hpp"
#include "grammar/axis_list.hpp"
#include "validator/commands/command_check.hpp"
#include "validator/values/kind_of_list.hpp"
#include "validator/values/list_reader.hpp"
#include "validator/values/merge_lists.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
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
constexpr Sentence image{"the file \"{file}\" is a coefficient image, not a list",
                         "die Datei „{file}“ ist ein Koeffizientenabbild, keine Liste"};

}  // namespace axisc::validator::says

namespace axisc::validator {
namespace {

constexpr std::string_view separators = "/\\";

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

/// `name` relative to the folder of `path`.
std::string beside(std::string const& path, std::string const& name) {
  if (is_absolute(name)) return name;
  return path.substr(0, path.size() - file_name(path).size()) + name;
}

bool ends_in(std::string_view path, std::string_view extension) {
  if (path.size() < extension.size()) return false;
  return ascii::equal_ignoring_case(path.substr(path.size() - extension.size()), extension);
}

std::variant<std::string, configuration::FileError> read_text(configuration::Files& files,
                                                              std::string const& path) {
  std::variant<std::string, configuration::FileError> bytes = files.read(path);
  if (auto const* const text = std::get_if<std::string>(&bytes)) {
    std::variant<std::monostate, configuration::FileError> const problem = configuration::check_text(*text);
    if (auto const* const error = std::get_if<configuration::FileError>(&problem)) return *error;
  }
  return bytes;
}

LoadedList parse(SourceSet const& sources, SourceId source, schema::Catalogue const& catalogue) {
  SourceText const& text = sources[source];
  LoadedList list;
  list.source = source;
  list.catalogue = catalogue;
  ReadList read = read_list(text, catalogue);
  list.kind = kind_of_list(text, read.tree, read.readings);
  if (list.kind != configuration::ListKind::axis) read = judge_list(text, {}, catalogue);
  list.tree = std::move(read.tree);
  list.readings = std::move(read.readings);
  list.lost = lost_assignments(text, list.tree, list.readings, catalogue);
  return list;
}

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
  }
  return says::not_readable;
}

class Loader {
 public:
  Loader(configuration::Files& files, CheckOptions const& options, SourceSet& sources, LoadedMachine& machine)
      : files_(files), options_(options), sources_(sources), machine_(machine) {}

  std::optional<configuration::FileError> load(std::string const& path) {
    machine_.path = path;
    machine_.name = without_extension(file_name(path));
    machine_.files.push_back(path);
    if (auto const error = ends_in(path, ".nc") ? load_program() : load_text()) return *error;
    if (machine_.groups.empty()) add_default_group();
    for (LoadedGroup& group : machine_.groups) {
      for (std::size_t const program : common_programs_) {
        if (!runs_in(group, program)) group.programs.push_back(program);
      }
    }
    if (options_.cycle_time) machine_.cycle_time = options_.cycle_time;
    machine_.build = options_.build;
    return std::nullopt;
  }

 private:
  std::optional<configuration::FileError> load_program() {
    auto const program = add_program(std::string(file_name(machine_.path)), machine_.path);
    if (auto const* const error = std::get_if<configuration::FileError>(&program)) return *error;
    return std::nullopt;
  }

  /// A list or a machine file.
  std::optional<configuration::FileError> load_text() {
    std::variant<std::string, configuration::FileError> bytes = read_text(files_, machine_.path);
    if (auto const* const error = std::get_if<configuration::FileError>(&bytes)) return *error;
    auto& text = std::get<std::string>(bytes);
    bool const is_machine = ends_in(machine_.path, ".json") && configuration::looks_like_machine_file(text);
    SourceId const source = sources_.add(SourceText(machine_.path, std::move(text)));
    if (is_machine) {
      load_machine(source);
    } else {
      load_single(source);
    }
    return std::nullopt;
  }

  void load_single(SourceId source) {
    machine_.lists.push_back(
        {.name = std::string(file_name(machine_.path)), .list = parse(sources_, source, options_.catalogue)});
    if (machine_.lists.front().list.kind != configuration::ListKind::axis) return;
    LoadedAxis& axis = add_axis(0, std::nullopt);
    EffectiveValue const& name = axis.merged.values.at("kopf.log_achs_name");
    bool const named = name.set() && !name.unusable && !name.value.text.empty();
    axis.name = named ? std::string(name.value.text) : machine_.name;
    machine_.name = axis.name;
  }

  void load_machine(SourceId source) {
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

  /// None for an axis whose list could not be read.
  [[nodiscard]] std::optional<std::size_t> axis_named(configuration::LocatedText const& name) const {
    auto const axis = std::find_if(machine_.axes.begin(), machine_.axes.end(),
                                   [&](LoadedAxis const& known) { return known.name == name.text; });
    if (axis == machine_.axes.end()) return std::nullopt;
    return static_cast<std::size_t>(axis - machine_.axes.begin());
  }

  void add_group(configuration::MachineFileGroup const& named) {
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

  void add_default_group() {
    LoadedGroup group;
    for (std::size_t axis = 0; axis < machine_.axes.size(); ++axis) {
      if (machine_.axes[axis].type != machine::AxisType::spindle) group.axes.push_back(axis);
    }
    if (!group.axes.empty()) machine_.groups.push_back(std::move(group));
  }

  void add_claims(configuration::MachineFileGantry const& gantry) {
    std::optional<std::size_t> const master = axis_named(gantry.master);
    if (!master) return;
    machine_.gantry_claims.push_back({.axis = *master, .master = std::nullopt, .place = gantry.master.place});
    for (configuration::LocatedText const& name : gantry.slaves) {
      std::optional<std::size_t> const slave = axis_named(name);
      if (!slave || slave == master) continue;
      machine_.gantry_claims.push_back({.axis = *slave, .master = master, .place = name.place});
    }
  }

  LoadedAxis& add_axis(std::size_t list, std::optional<machine::AxisType> type) {
    if (options_.axis_type) type = options_.axis_type;
    std::optional<bool> rotary;
    if (type) rotary = *type != machine::AxisType::translatory;
    MergedValues merged = merge_lists(machine_.list_of_defaults(), machine_.lists[list].list, rotary);
    machine::AxisType const known_type = type.value_or(axis_type_of(merged.values));
    machine_.axes.push_back(
        {.name = {}, .type = known_type, .list = list, .drive = {}, .merged = std::move(merged)});
    return machine_.axes.back();
  }

  /// Index of the list; a file that several axes name is read once.
  std::optional<std::size_t> list_named(configuration::LocatedText const& name) {
    std::string const path = beside(machine_.path, name.text);
    std::string const key = std::filesystem::path(path).lexically_normal().generic_string();
    auto const known = by_path_.find(key);
    if (known != by_path_.end()) return known->second;
    std::variant<std::string, configuration::FileError> bytes = read_text(files_, path);
    if (auto const* const error = std::get_if<configuration::FileError>(&bytes)) {
      missing(name, *error);
      return std::nullopt;
    }
    machine_.files.push_back(path);
    SourceId const source = sources_.add(SourceText(path, std::move(std::get<std::string>(bytes))));
    std::string const shown(is_absolute(name.text) ? file_name(name.text) : std::string_view(name.text));
    machine_.lists.push_back({.name = shown, .list = parse(sources_, source, options_.catalogue)});
    by_path_.emplace(key, machine_.lists.size() - 1);
    return machine_.lists.size() - 1;
  }

  /// Index of the program.
  std::variant<std::size_t, configuration::FileError> add_program(std::string name, std::string const& path) {
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
    return machine_.programs.size() - 1;
  }

  /// Index of the program; a file that is named several times is read once.
  std::optional<std::size_t> program_named(configuration::LocatedText const& name) {
    std::string const path = beside(machine_.path, name.text);
    std::string const key = std::filesystem::path(path).lexically_normal().generic_string();
    auto const known = programs_by_path_.find(key);
    if (known != programs_by_path_.end()) return known->second;
    std::variant<std::size_t, configuration::FileError> const program = add_program(name.text, path);
    if (auto const* const error = std::get_if<configuration::FileError>(&program)) {
      missing(name, *error);
      return std::nullopt;
    }
    machine_.files.push_back(path);
    programs_by_path_.emplace(key, std::get<std::size_t>(program));
    return std::get<std::size_t>(program);
  }

  [[nodiscard]] static bool runs_in(LoadedGroup const& group, std::size_t program) {
    return std::find(group.programs.begin(), group.programs.end(), program) != group.programs.end();
  }

  void missing(configuration::LocatedText const& name, configuration::FileError error) {
    machine_.complete = false;
    Finding& finding = machine_.findings.emplace_back();
    finding.code = configuration::machine_file_code;
    finding.place = name.place;
    finding.message = {.sentence = text_of(error), .arguments = {{"file", name.text}}};
  }

  configuration::Files& files_;
  CheckOptions const& options_;
  SourceSet& sources_;
  LoadedMachine& machine_;
  std::map<std::string, std::size_t> by_path_;
  std::map<std::string, std::size_t> programs_by_path_;
  std::vector<std::size_t> common_programs_;  ///< those that every group runs
};

}  // namespace

bool forget_guesses(LoadedMachine& machine) {
  std::size_t guesses = 0;
  for (NamedList& named : machine.lists) {
    guesses += std::erase_if(named.list.lost, [](LostAssignment const& lost) { return lost.guessed; });
  }
  if (guesses == 0) return false;
  for (LoadedAxis& axis : machine.axes) {
    axis.merged = merge_lists(machine.list_of_defaults(), machine.lists[axis.list].list,
                              axis.type != machine::AxisType::translatory);
  }
  return true;
}

bool program_gives_order(LoadedMachine const& machine, std::size_t axis) {
  auto const belongs = [axis](LoadedGroup const& group) {
    return std::find(group.axes.begin(), group.axes.end(), axis) != group.axes.end();
  };
  for (LoadedGroup const& group : machine.groups) {
    if (!belongs(group)) continue;
    for (std::size_t const program : group.programs) {
      if (machine.programs[program].gives_order) return true;
    }
    for (configuration::LocatedText const& text : machine.filter_sets) {
      auto const command = grammar::parse_nc_command(text.text);
      if (command && gives_order(*command, text.text)) return true;
    }
  }
  return false;
}

std::variant<LoadedMachine, configuration::FileError> load(configuration::Files& files,
                                                           std::string const& path,
                                                           CheckOptions const& options, SourceSet& sources) {
  std::variant<LoadedMachine, configuration::FileError> loaded;
  auto const error = Loader(files, options, sources, std::get<LoadedMachine>(loaded)).load(path);
  if (error) loaded = *error;
  return loaded;
}

}  // namespace axisc::validator
