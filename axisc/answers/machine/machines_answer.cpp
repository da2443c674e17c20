#include "axisc/answers/machine/machines_answer.hpp"

#include "axisc/answers/labels.hpp"
#include "axisc/answers/machine/machine_answer.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/workspace/machine_inputs.hpp"
#include "configuration/machine_file.hpp"
#include "system/file.hpp"

#include <deque>

namespace axisc::says {

constexpr Sentence machines_of{"machines of {input}", "Maschinen von {input}"};
constexpr Sentence machine_name{"machine", "Maschine"};
constexpr Sentence described_by{"described by", "beschrieben in"};
constexpr Sentence time_from{"cycle time from", "Zykluszeit aus"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;
using validator::LoadedMachine;

namespace {

std::optional<std::string> cycle_time_from(Workspace& workspace, LoadedMachine const& machine,
                                           SourceSet const& sources) {
  if (!machine.cycle_time) return std::nullopt;
  auto const options = workspace.options_of(machine.path);
  if (options.cycle_time) {
    bool const is_callers = workspace.overrides().options.cycle_time.has_value();
    auto const* const settings = is_callers ? nullptr : workspace.settings().find(machine.path);
    return settings != nullptr ? std::optional(settings->file) : std::nullopt;
  }
  if (machine.start_up && machine.start_up->real_time.cycle_time) {
    return place_text(machine.start_up->real_time.place, sources);
  }
  if (!machine.machine_file) return std::nullopt;
  std::deque<Finding> mistakes;
  auto const file = configuration::read_machine_file(sources, *machine.machine_file, mistakes);
  return file.cycle_time ? std::optional(sources[*machine.machine_file].name()) : std::nullopt;
}

std::vector<Field> row_of(Workspace& workspace, Belonging const& belonging, LoadedMachine const& machine,
                          SourceSet const& sources) {
  Names axes;
  for (auto const& axis : machine.axes) axes.push_back(axis.name);
  bool const is_alone = !machine.machine_file && !machine.start_up;
  auto const axis = axis_of_list(machine, sources, belonging.name);
  auto const& time = machine.cycle_time;
  return {{"path", says::described_by, machine.path},
          {"machine", says::machine_name, machine.name},
          {"axes", labels::axes, std::move(axes)},
          data("alone", is_alone),
          data("axis", axis ? Value(machine.axes[*axis].name) : Value()),
          {"cycle_time_us", labels::cycle_time,
           time ? Value(exact(time->microseconds(), Unit::microsecond)) : Value()},
          {"cycle_time_from", says::time_from, Value(cycle_time_from(workspace, machine, sources))}};
}

}  // namespace

Document machines_answer(Workspace& workspace, std::string const& input) {
  std::vector<Belonging> found;
  if (system::kind_of(input) == system::FileKind::folder) {
    for (auto const& path : machine_inputs(input)) found.push_back({.machine = path, .name = path});
  } else {
    found.push_back(machine_of_input(workspace, {.input = input}));
  }
  Table machines{.key = "machines"};
  for (auto const& belonging : found) {
    SourceSet sources;
    auto const machine = loaded_machine(workspace, belonging.machine, sources);
    if (!machine.axes.empty()) add_row(machines, row_of(workspace, belonging, machine, sources));
  }
  return {.version = 1,
          .title = Words(says::machines_of, {{"input", input}}),
          .blocks = {std::move(machines)},
          .csv_table = "machines"};
}

}  // namespace axisc
