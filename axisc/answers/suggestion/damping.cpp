#include "axisc/answers/suggestion/damping.hpp"

#include "analysis/tuning/position_control/control_lines.hpp"
#include "axisc/answers/suggestion/new_findings.hpp"
#include "axisc/settings/plant_file.hpp"
#include "validator/views/position_control_view.hpp"

#include <algorithm>

namespace axisc {

namespace {

bool is_in_gantry(machine::Machine const& machine, std::size_t axis) {
  return machine.axes[axis].gantry_master ||
         std::any_of(machine.axes.begin(), machine.axes.end(),
                     [axis](machine::AxisConfiguration const& other) { return other.gantry_master == axis; });
}

/// Stages of the lists that the suggestion does not have.
void switch_off_others(std::vector<tuning::ListLine>& lines, validator::EffectiveValues const& values) {
  validator::PositionControlView const view(values);
  for (auto const& stage : view.stages) {
    auto const name = validator::parameter_name(stage.mode);
    bool const is_chosen = std::any_of(lines.begin(), lines.end(),
                                       [&](tuning::ListLine const& line) { return line.name == name; });
    if (!is_chosen && (stage.mode.unusable || stage.active_mode())) {
      lines.push_back({.name = name, .value = "NOT_ACTIVE"});
    }
  }
}

}  // namespace

DampingAnswer damping_for(SuggestionSubject const& subject, tuning::Task const& task,
                          std::string const& plant_path) {
  auto const& machine = subject.machine;
  auto const& axis = machine.axes[subject.axis];
  auto const plant = read_plant(plant_path, axis.name);
  DampingAnswer answer{.plant_path = plant_path, .kv = plant.kv, .found = InGantry{}};
  if (is_in_gantry(machine, subject.axis)) return answer;
  auto found = tuning::damp({.cycle_time = task.cycle_time,
                             .axis = axis,
                             .plant = plant,
                             .resonances = task.resonances,
                             .velocity = task.velocity,
                             .dynamics = task.dynamics,
                             .radius = task.radius,
                             .tolerance = task.tolerance,
                             .least_vibration = task.goal == tuning::Goal::surface});
  if (auto const* const none = std::get_if<tuning::NoDampingFound>(&found)) {
    answer.found = *none;
    return answer;
  }
  auto const& damping = answer.found.emplace<tuning::Damping>(std::get<tuning::Damping>(std::move(found)));
  auto const& loaded = subject.loaded;
  for (auto const index : concerned_axes(subject)) {
    auto const& listed = loaded.axes[index];
    answer.axes.push_back({.axis = listed.name, .list = loaded.lists[listed.list].name, .lines = {}});
    if (index != subject.axis) continue;
    auto& lines = answer.axes.back().lines;
    lines = tuning::control_lines(damping.control);
    switch_off_others(lines, listed.merged.values);
    answer.edits = edit_lists(loaded, LinesByAxis{{index, lines}}, subject.sources);
  }
  if (!answer.edits.refused) {
    answer.findings = NewFindings(subject.path, subject.workspace).of(answer.edits.edited);
  }
  return answer;
}

}  // namespace axisc
