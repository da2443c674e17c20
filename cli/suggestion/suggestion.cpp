#include "cli/suggestion/suggestion.hpp"

#include "cli/execution/group_chains.hpp"
#include "cli/files/path_machine.hpp"
#include "cli/suggestion/new_findings.hpp"
#include "motion/feed_limits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axisc::cli {

namespace {

using tuning::Chain;

constexpr double right_angle = std::numbers::pi / 2;

Chain chain_of(machine::AxisConfiguration const& axis) {
  Chain chain;
  for (auto const& filter : axis.filters) chain.filters.push_back(filter.specification);
  if (axis.kernel) chain.kernel = axis.kernel->specification;
  return chain;
}

machine::Machine with_chain(machine::Machine machine, std::vector<std::size_t> const& axes,
                            Chain const& chain, machine::KernelFamily family) {
  for (auto const index : axes) {
    auto& axis = machine.axes[index];
    axis.filters.clear();
    axis.kernel.reset();
    std::uint32_t place = chain.kernel && family == machine::KernelFamily::hsc ? 1 : 0;
    for (auto const& filter : chain.filters) {
      axis.filters.push_back({.index = place, .specification = filter});
      ++place;
    }
    if (!chain.kernel) continue;
    axis.kernel = machine::ConfiguredKernel{.family = family,
                                            .index = 0,
                                            .specification = *chain.kernel,
                                            .on_at_start = family == machine::KernelFamily::fir};
  }
  return machine;
}

void predict(Setting& setting, machine::Machine const& machine, SuggestionSubject const& subject,
             tuning::Task const& task) {
  GroupChains chains(machine, subject.group, filters_on(), subject.path);
  auto const answers = chains.answers(std::nullopt);
  auto const feed_of = [&](std::optional<double> const& velocity) -> std::optional<double> {
    if (!velocity) return std::nullopt;
    return *velocity / path_velocity(1, task.cycle_time);
  };
  setting.corner = motion::predict_corner(answers, task.velocity, right_angle);
  setting.circle = motion::predict_circle(answers, task.velocity, task.radius);
  setting.corner_feed = feed_of(motion::corner_velocity(answers, right_angle, task.tolerance));
  setting.circle_feed = feed_of(motion::circle_velocity(answers, task.radius, task.tolerance));
}

/// In the unit of NC programs; inches are rounded down to millionths.
double programmed_tolerance(tuning::Task const& task, machine::Machine const& machine) {
  constexpr double mm_per_inch = 25.4;
  constexpr double millionths = 1e6;
  double const mm = task.tolerance / motion::units_per_mm;
  return machine.inch ? std::floor(mm / mm_per_inch * millionths) / millionths : mm;
}

}  // namespace

std::vector<std::size_t> concerned_axes(SuggestionSubject const& subject) {
  auto const& machine = subject.machine;
  auto axes = machine.groups[subject.group].axes;
  for (std::size_t i = 0; i < machine.axes.size(); ++i) {
    auto const& master = machine.axes[i].gantry_master;
    auto const contains = [&](std::size_t axis) {
      return std::find(axes.begin(), axes.end(), axis) != axes.end();
    };
    if (master && contains(*master) && !contains(i)) axes.push_back(i);
  }
  return axes;
}

std::variant<Suggestion, NoSuggestion> suggestion_for(SuggestionSubject const& subject, tuning::Task task) {
  auto const enumeration = tuning::enumerate(task);
  auto const choice = tuning::choose(enumeration.candidates, task.goal);
  if (!choice) {
    NoSuggestion none{.looked_at = enumeration.looked_at, .keeps = enumeration.candidates.size()};
    for (auto const& candidate : enumeration.candidates) {
      if (candidate.is_clean) {
        none.least_vibration = std::min(none.least_vibration, candidate.figures.vibration);
      }
    }
    return none;
  }
  auto const& machine = subject.machine;
  auto const axes = concerned_axes(subject);
  Suggestion found{.axis = machine.axes[subject.axis].name,
                   .group = machine.groups[subject.group].name,
                   .cycle_time = machine.cycle_time,
                   .recommended = choice->recommended,
                   .not_clean = choice->not_clean,
                   .looked_at = enumeration.looked_at};
  for (auto const axis : machine.groups[subject.group].axes) found.axes.push_back(machine.axes[axis].name);

  auto const present = chain_of(machine.axes[subject.axis]);
  auto const response = tuning::impulse_responses(std::span(&present, 1), task.cycle_time).front();
  if (!response.blocks_constant()) {
    found.present = Setting{.chain = present, .figures = tuning::Judge(task).figures(response)};
    predict(*found.present, machine, subject, task);
  }
  NewFindings const findings(subject.path, subject.job);
  for (std::size_t i = 0; i < tuning::senses; ++i) {
    auto const& [chain, figures, is_clean] = choice->chosen[i];
    auto& alternative = found.alternatives[i];
    alternative.setting = {.chain = chain, .figures = figures};
    predict(alternative.setting, with_chain(machine, axes, chain, task.family), subject, task);
    for (auto const axis : axes) {
      alternative.axes.push_back(lines_of(subject.loaded, axis, chain, task.family));
    }
    alternative.edits = edit_lists(subject.loaded, axes, subject.sources, chain, task.family);
    if (!alternative.edits.refused) {
      alternative.findings = findings.of(alternative.edits.edited);
    }
    alternative.command = tuning::filter_command(chain, task.family, programmed_tolerance(task, machine));
  }
  found.tolerance_mm = task.tolerance / motion::units_per_mm;
  found.radius_mm = task.radius / motion::units_per_mm;
  found.feed = task.velocity / path_velocity(1, task.cycle_time);
  found.task = std::move(task);
  return found;
}

}  // namespace axisc::cli
