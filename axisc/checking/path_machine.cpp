#include "axisc/checking/path_machine.hpp"

#include "axisc/checking/compilable.hpp"
#include "axisc/checking/machine_input.hpp"
#include "axisc/workspace/inputs.hpp"
#include "codegen/image_writer.hpp"
#include "diagnostics/joined.hpp"
#include "validator/commands/command_check.hpp"

#include <algorithm>

namespace axisc::says {

constexpr Sentence unusable_command{"the command \"{value}\" cannot be used: {reason}",
                                    "der Befehl \"{value}\" ist nicht verwendbar: {reason}"};
constexpr Sentence which_axis{"{file} has the axes {axes}: name one with --axis",
                              "{file} hat die Achsen {axes}: eine davon mit --axis nennen"};
constexpr Sentence no_path_axes{"{file} has no group of axes that could move on a path",
                                "{file} hat keine Gruppe von Achsen, die eine Bahn fahren könnten"};
constexpr Sentence too_many_axes{"group {group} has {axes} axes; a path has at most {limit}",
                                 "Gruppe {group} hat {axes} Achsen; eine Bahn hat höchstens {limit}"};
constexpr Sentence unknown_group{"there is no group \"{group}\"; the groups are {groups}",
                                 "es gibt keine Gruppe \"{group}\"; die Gruppen sind {groups}"};

}  // namespace axisc::says

namespace axisc {

validator::CommandLimits command_limits(machine::Machine const& machine, machine::MachineGroup const& group) {
  validator::CommandLimits limits{.cycle_time = machine.cycle_time};
  for (auto const axis : group.axes) {
    auto const& kernel = machine.axes[axis].kernel;
    if (!kernel) continue;
    limits.time_delay = limits.time_delay || kernel->specification.type == design::KernelType::time_delay;
    limits.readings.kernels = kernel->specification.reading;
    limits.readings.cycle_time = kernel->specification.cycle_time;
  }
  return limits;
}

Belonging machine_of_input(Workspace& workspace, MachineRequest const& request) {
  auto const path = machine_input(request.input);
  if (request.alone || path == "-") return {.machine = path, .name = path};
  return workspace.machine_of(path);
}

std::size_t axis_named(machine::Machine const& machine, std::string const& name) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < machine.axes.size(); ++i) {
    if (machine.axes[i].name == name) return i;
    names.push_back(machine.axes[i].name);
  }
  throw unknown_axis(name, names);
}

std::optional<std::size_t> axis_of_list(validator::LoadedMachine const& loaded, SourceSet const& sources,
                                        std::string const& list) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < loaded.axes.size(); ++i) {
    if (sources[loaded.lists[loaded.axes[i].list].list.source].name() != list) continue;
    if (found) return std::nullopt;
    found = i;
  }
  return found;
}

RequestedMachine::RequestedMachine(Workspace& workspace, MachineRequest const& request,
                                   ErrorSink const& errors) {
  auto belonging = machine_of_input(workspace, request);
  path = std::move(belonging.machine);
  input = std::move(belonging.name);
  checked = check_machine(workspace, path, errors, sources, loaded);
  if (!checked) return;
  require_cycle_time(path, *checked);
  add_settings_files(workspace.settings(), path, checked->files);
}

std::size_t RequestedMachine::axis(std::optional<std::string> const& name) const {
  auto const& axes = checked->machine->axes;
  if (name) return axis_named(*checked->machine, *name);
  if (axes.size() == 1) return 0;
  if (auto const of_list = axis_of_list(*loaded, sources, input)) return *of_list;
  std::vector<std::string> names;
  names.reserve(axes.size());
  for (auto const& one : axes) names.push_back(one.name);
  throw Failure({says::which_axis, {{"file", path}, {"axes", joined(names)}}});
}

std::optional<CheckedMachine> checked_machine(Workspace& workspace, MachineRequest const& request,
                                              ErrorSink const& errors) {
  RequestedMachine requested(workspace, request, errors);
  if (!requested.checked) return std::nullopt;
  auto& result = *requested.checked;
  CheckedMachine checked{.machine = *std::move(result.machine), .files = std::move(result.files)};
  if (requested.path == requested.input) return checked;
  auto const axis = axis_of_list(*requested.loaded, requested.sources, requested.input);
  if (!axis) return checked;
  checked.axis = checked.machine.axes[*axis].name;
  for (auto const& group : checked.machine.groups) {
    bool const has_axis = std::find(group.axes.begin(), group.axes.end(), *axis) != group.axes.end();
    if (has_axis) checked.group = group.name;
  }
  return checked;
}

ImageFile image_of(machine::Machine const& machine, std::string const& path,
                   codegen::ImageOptions const& options) {
  auto const bytes = codegen::write_image(machine, options);
  auto contents = image::read_image(bytes);
  if (auto const* const status = std::get_if<axisrt_status>(&contents)) throw unusable_image(path, *status);
  return {.bytes = codegen::AlignedBytes(bytes),
          .contents = std::get<image::ImageContents>(std::move(contents))};
}

motion::GroupRuntime group_runtime(ImageFile const& image, machine::MachineGroup const& group,
                                   std::string const& path, machine::Machine const* machine) {
  if (group.axes.size() > motion::most_axes) {
    throw Failure({says::too_many_axes,
                   {{"group", group.name},
                    {"axes", std::to_string(group.axes.size())},
                    {"limit", std::to_string(motion::most_axes)}}});
  }
  auto runtime = motion::GroupRuntime::create(image.bytes.bytes(), image.contents, group.axes);
  if (auto const* const status = std::get_if<axisrt_status>(&runtime)) throw unusable_image(path, *status);
  auto made = std::get<motion::GroupRuntime>(std::move(runtime));
  if (machine != nullptr) {
    std::vector<machine::PositionDelay> at_start;
    std::vector<machine::PositionDelay> fed_forward;
    for (auto const axis : group.axes) {
      at_start.push_back(machine::position_delay(machine->axes[axis].drive_path));
      fed_forward.push_back(machine::position_delay(machine->axes[axis].fed_forward_path));
    }
    made.delay(at_start, fed_forward);
  }
  return made;
}

std::size_t chosen_group(machine::Machine const& machine, std::optional<std::string> const& name,
                         std::string const& path) {
  std::string known;
  for (std::size_t i = 0; i < machine.groups.size(); ++i) {
    auto const& group = machine.groups[i];
    if (group.axes.empty()) continue;
    if (!name || group.name == *name) return i;
    known += (known.empty() ? "" : ", ") + group.name;
  }
  if (!name || known.empty()) {
    throw Failure({says::no_path_axes, {{"file", path}}});
  }
  throw Failure({says::unknown_group, {{"group", *name}, {"groups", known}}});
}

std::string why_unusable(validator::CheckedCommand const& checked, Language language) {
  if (checked.mistakes.empty()) return {};
  auto const& mistake = checked.mistakes.front();
  auto const what = render(mistake.message, language);
  return mistake.label ? what + " (" + render(*mistake.label, language) + ")" : what;
}

machine::FilterCommand read_filter_command(machine::Machine const& machine,
                                           machine::MachineGroup const& group, std::string const& text,
                                           Language language) {
  auto const checked = validator::parse_filter_command(text, command_limits(machine, group));
  if (checked.command && checked.mistakes.empty()) return *checked.command;
  throw Failure({says::unusable_command, {{"value", text}, {"reason", why_unusable(checked, language)}}});
}

motion::FilterCommandReader filter_command_reader(machine::Machine const& machine,
                                                  machine::MachineGroup const& group) {
  return [limits = command_limits(machine, group)](grammar::NcCommand const& command, std::string_view text) {
    auto const checked = validator::check_command(command, text, limits, validator::Variables::refused);
    motion::FilterCommandReading reading{.command = checked.command, .mistakes = {}};
    for (validator::CommandMistake const& mistake : checked.mistakes) {
      reading.mistakes.push_back({.code = mistake.code, .span = mistake.span, .message = mistake.message});
    }
    return reading;
  };
}

std::vector<machine::FilterCommand> filters_on() {
  using machine::FilterCommand;
  using machine::FilterSwitch;
  return {FilterCommand{.filter_switch = FilterSwitch::on, .parameters = {}},
          FilterCommand{.filter_switch = FilterSwitch::on, .hsc = true, .parameters = {}},
          FilterCommand{.filter_switch = FilterSwitch::on, .parameters = machine::guard_parameters()}};
}

}  // namespace axisc
