#include "axisc/answers/suggestion/suggestion.hpp"

#include "analysis/motion/feed_limits.hpp"
#include "axisc/answers/execution/group_chains.hpp"
#include "axisc/answers/suggestion/new_findings.hpp"
#include "axisc/checking/path_machine.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axisc {

namespace {

using tuning::Chain;

/// The rule about parameters of a guard that nothing switches on.
constexpr std::string_view guard_unused = "AX3029";
constexpr double right_angle = std::numbers::pi / 2;

Chain chain_of(machine::AxisConfiguration const& axis) {
  Chain chain;
  for (auto const& filter : axis.filters) chain.filters.push_back(filter.specification);
  if (axis.kernel) chain.kernel = axis.kernel->specification;
  return chain;
}

machine::Machine with_chain(machine::Machine machine, std::vector<std::size_t> const& axes,
                            Chain const& chain, machine::KernelFamily linear_phase) {
  auto const family = tuning::family_of(chain, linear_phase);
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
                                            .on_at_start = family != machine::KernelFamily::hsc};
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

/// Settings whose answers to a step differ by less than a 1000th are the same for who has to choose one.
bool does_the_same(tuning::ImpulseResponse const& one, tuning::ImpulseResponse const& other) {
  constexpr double noticeable = 1e-3;
  double apart = 0;
  for (std::size_t n = 0; n < std::max(one.taps.size(), other.taps.size()); ++n) {
    auto const tap = [n](tuning::ImpulseResponse const& of) { return n < of.taps.size() ? of.taps[n] : 0; };
    apart += tap(one) - tap(other);
    if (std::abs(apart) > noticeable) return false;
  }
  return true;
}

bool has_active_guard(machine::AxisConfiguration const& axis) {
  return axis.kernel && axis.kernel->family == machine::KernelFamily::guard && axis.kernel->on_at_start;
}

std::array<std::size_t, tuning::senses> proposed(std::array<tuning::Candidate, tuning::senses> const& chosen,
                                                 design::CycleTime cycle_time) {
  std::vector<Chain> chains;
  chains.reserve(chosen.size());
  for (auto const& candidate : chosen) chains.push_back(candidate.chain);
  auto const responses = tuning::impulse_responses(chains, cycle_time);
  std::array<std::size_t, tuning::senses> first{};
  for (std::size_t i = 0; i < tuning::senses; ++i) {
    first.at(i) = i;
    for (std::size_t k = i; k-- > 0;) {
      if (first.at(k) == k && does_the_same(responses[k], responses[i])) first.at(i) = k;
    }
  }
  return first;
}

}  // namespace

std::vector<tuning::Sense> Suggestion::senses_of(std::size_t index) const {
  std::vector<tuning::Sense> found;
  for (std::size_t i = 0; i < tuning::senses; ++i) {
    if (proposed.at(i) == index) found.push_back(static_cast<tuning::Sense>(i));
  }
  return found;
}

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

std::variant<NoSuggestion, Suggestion> suggestion_for(SuggestionSubject const& subject, tuning::Task task) {
  tuning::Judge const judge(task);
  auto enumeration = tuning::enumerate(task, judge);
  auto const choice = tuning::choose(enumeration.candidates, judge, task.goal);
  if (!choice) {
    return NoSuggestion{.looked_at = enumeration.looked_at,
                        .keeps = enumeration.candidates.size(),
                        .least_vibration = tuning::least_vibration(enumeration.candidates, judge)};
  }
  auto const& machine = subject.machine;
  auto const axes = concerned_axes(subject);
  Suggestion found{.axis = machine.axes[subject.axis].name,
                   .group = machine.groups[subject.group].name,
                   .cycle_time = machine.cycle_time,
                   .proposed = proposed(choice->chosen, machine.cycle_time),
                   .recommended = choice->recommended,
                   .not_clean = choice->not_clean,
                   .looked_at = enumeration.looked_at};
  for (auto const axis : machine.groups[subject.group].axes) found.axes.push_back(machine.axes[axis].name);

  auto const present = chain_of(machine.axes[subject.axis]);
  auto const response = tuning::impulse_responses(std::span(&present, 1), task.cycle_time).front();
  if (!response.blocks_constant()) {
    found.present =
        Setting{.chain = present, .figures = judge.figures(response), .guard = guard_coverage(present, task)};
    predict(*found.present, machine, subject, task);
  }
  NewFindings const findings(subject.path, subject.workspace);
  for (std::size_t i = 0; i < tuning::senses; ++i) {
    auto const& chain = choice->chosen[i].chain;
    auto& alternative = found.alternatives[i];
    alternative.setting = {
        .chain = chain, .figures = choice->chosen[i].figures, .guard = guard_coverage(chain, task)};
    predict(alternative.setting, with_chain(machine, axes, chain, task.family), subject, task);
    for (auto const axis : axes) {
      alternative.axes.push_back(lines_of(subject.loaded, axis, chain, task.family));
    }
    alternative.edits = edit_lists(subject.loaded, axes, subject.sources, chain, task.family);
    if (!alternative.edits.refused) {
      alternative.findings = findings.of(alternative.edits.edited);
    }
    alternative.replaces_guard =
        !tuning::has_guard(chain) && std::any_of(axes.begin(), axes.end(), [&](std::size_t axis) {
          return has_active_guard(machine.axes[axis]);
        });
    if (alternative.replaces_guard) std::erase(alternative.findings, guard_unused);
    alternative.command = tuning::filter_command(chain, task.family, programmed_tolerance(task, machine));
  }
  found.tolerance_mm = task.tolerance / motion::units_per_mm;
  found.radius_mm = task.radius / motion::units_per_mm;
  found.feed = task.velocity / path_velocity(1, task.cycle_time);
  found.task = std::move(task);
  return found;
}

}  // namespace axisc
