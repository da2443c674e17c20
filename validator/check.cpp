#include "validator/check.hpp"

#include "validator/building/machine_build.hpp"
#include "validator/engine/engine.hpp"
#include "validator/loading/loading.hpp"
#include "validator/views/axis_views.hpp"
#include "validator/views/gantry.hpp"

#include <deque>
#include <utility>

namespace axisc::validator {
namespace {

std::deque<AxisViews> views_of(LoadedMachine const& machine) {
  std::deque<AxisViews> views;
  design::CycleTime const cycle_time = machine.cycle_time.value_or(design::CycleTime{});
  for (LoadedAxis const& axis : machine.axes) views.emplace_back(axis.merged.values, cycle_time);
  return views;
}

}  // namespace

CheckResult check(LoadedMachine& machine, configuration::Files& files, CheckOptions const& options,
                  SourceSet& sources, FindingSink const& sink) {
  CheckResult result;
  result.cycle_time_known = machine.cycle_time.has_value();
  // Whether shown or not: the machine lacks the parts that are missing or cannot be understood.
  bool const is_understood = machine.complete && machine.findings.empty();

  machine.gantries = gantries_of(machine);
  std::deque<AxisViews> views = views_of(machine);
  EngineResult const judged = run_rules(machine, views, options, sources, sink);
  result.cycle_time_assumed = judged.cycle_time_assumed;
  result.obstacle = !is_understood         ? Obstacle::incomplete
                    : judged.has_errors    ? Obstacle::errors
                    : machine.axes.empty() ? Obstacle::no_axis
                                           : Obstacle::none;
  if (options.machine && result.obstacle == Obstacle::none) {
    if (forget_guesses(machine)) views = views_of(machine);
    BuiltMachine built = build_machine(machine, views, sources, files);
    result.machine = std::move(built.machine);
    result.not_compiled = std::move(built.not_compiled);
  }
  result.is_other_list = machine.axes.empty() && !machine.start_up && !machine.machine_file &&
                         (!machine.other_lists.empty() || machine.list_of_unknown_kind.has_value());
  result.is_update_of_axis = result.is_other_list && !machine.other_lists.empty() &&
                             machine.other_lists.front().list.kind == configuration::ListKind::axis;
  result.files = machine.files;
  return result;
}

CheckResult check(configuration::Files& files, std::string const& path, CheckOptions const& options,
                  SourceSet& sources, FindingSink const& sink) {
  std::variant<LoadedMachine, configuration::FileError> loaded = load(files, path, options, sources);
  if (auto* const machine = std::get_if<LoadedMachine>(&loaded)) {
    return check(*machine, files, options, sources, sink);
  }
  CheckResult result;
  result.unreadable = std::get<configuration::FileError>(loaded);
  return result;
}

CheckResult check(configuration::Files& files, std::string const& path, CheckOptions const& options,
                  SourceSet& sources) {
  std::vector<Finding> findings;
  CheckResult result = check(files, path, options, sources,
                             [&findings](Finding& finding) { findings.push_back(std::move(finding)); });
  result.findings = std::move(findings);
  return result;
}

}  // namespace axisc::validator
