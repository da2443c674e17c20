#include "validator/rules/unequal_filters.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/views/delay_budget.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::validator::says {

constexpr Sentence guard_on_at_start{
    "at start-up the Vibration Guard works in \"{axis}\" alone (`vib_guard.active`)",
    "beim Hochlauf wirkt der Vibration Guard nur in „{axis}“ (`vib_guard.active`)"};
constexpr Sentence on_at_start{
    "at start-up the linear-phase filter works in \"{axis}\" alone (`filter_fir.enable`)",
    "beim Hochlauf wirkt der linearphasige Filter nur in „{axis}“ (`filter_fir.enable`)"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
namespace {

// Delays that are computed in two ways may differ by rounding.
constexpr double rounding = 1e-6;

bool on_at_start(AxisDelay const& delay) {
  return delay.kernel && delay.kernel->on_at_start;
}

/// With all filters on.
double position_delay_of(DelayedAxis const& axis) {
  return axis.delay.cycles + axis.after_filters;
}

/// With the filters that work from start-up.
double delay_at_start(DelayedAxis const& axis) {
  return validator::at_start(axis.delay).cycles + axis.after_filters;
}

/// The largest difference that start-up or `#FILTER` may bring about.
double difference(AxisPair pair) {
  double const configured = std::abs(position_delay_of(pair.master) - position_delay_of(pair.slave));
  return std::max(configured, std::abs(delay_at_start(pair.master) - delay_at_start(pair.slave)));
}

/// Filters in series may be exchanged.
bool respond_alike(AxisPair pair) {
  AxisDelay const& master = pair.master.delay;
  AxisDelay const& slave = pair.slave.delay;
  bool const same_kernel = master.kernel.has_value() == slave.kernel.has_value() &&
                           (!master.kernel || master.kernel->specification == slave.kernel->specification);
  return same_kernel && on_at_start(master) == on_at_start(slave) &&
         std::is_permutation(master.filters.begin(), master.filters.end(), slave.filters.begin(),
                             slave.filters.end());
}

}  // namespace

bool PositionDifference::is_apart() const {
  return cycles >= rounding;
}

std::optional<DelayedAxis> delayed_axis(MachineContext const& context, std::size_t index) {
  LoadedAxis const& axis = context.machine.axes[index];
  auto delay = axis_delay(axis.merged.values, context.cycle_time);
  if (!delay) return std::nullopt;
  return DelayedAxis{axis, *std::move(delay), delay_after_filters(axis, context.cycle_time)};
}

std::optional<PositionDifference> compare_positions(AxisPair pair) {
  double const cycles = difference(pair);
  bool const filters_agree = respond_alike(pair);
  bool const feedforward_differs = pair.master.after_filters != pair.slave.after_filters;
  if (cycles < rounding && filters_agree) return std::nullopt;
  bool const slave_is_later = position_delay_of(pair.slave) >= position_delay_of(pair.master);
  if (filters_agree) {
    auto const* const of_slave = line_about_feedforward(pair.slave.axis);
    auto const* const of_master = line_about_feedforward(pair.master.axis);
    bool const is_of_slave = of_slave != nullptr && (slave_is_later || of_master == nullptr);
    auto const* const line = is_of_slave ? of_slave : of_master;
    if (line == nullptr) return std::nullopt;
    return PositionDifference{pair, cycles, is_of_slave ? pair.slave : pair.master, *line, false, true};
  }
  DelayShare const* const of_slave = largest_difference(pair.slave.delay, pair.master.delay);
  DelayShare const* const of_master = largest_difference(pair.master.delay, pair.slave.delay);
  bool const slave_is_longer = pair.slave.delay.cycles >= pair.master.delay.cycles;
  if (of_slave != nullptr && (slave_is_longer || of_master == nullptr)) {
    return PositionDifference{pair, cycles, pair.slave, *of_slave->cause, true, feedforward_differs};
  }
  if (of_master != nullptr) {
    return PositionDifference{pair, cycles, pair.master, *of_master->cause, true, feedforward_differs};
  }
  return std::nullopt;
}

Finding& report_difference(PositionDifference const& difference, SentenceRef headline,
                           MachineContext const& context, Report& report) {
  auto const& [pair, cycles, axis, cause, filters_differ, feedforward_differs] = difference;
  DelayedAxis const& other = &axis == &pair.slave ? pair.master : pair.slave;
  report.axis = axis.axis.name;
  Finding& finding =
      report.add(cause, {headline,
                         {{"master", pair.master.axis.name},
                          {"slave", pair.slave.axis.name},
                          {"cycles", counted_cycles(cycles)},
                          {"milliseconds", format_rounded(cycles * context.cycle_time.seconds() * 1e3, 4)}}});
  if (!filters_differ) {
    finding.label = delay_after_filters_of(axis);
    finding.notes.push_back(delay_after_filters_of(other));
    return finding;
  }
  finding.label = delay_of(axis);
  finding.notes.push_back(delay_of(other));
  if (feedforward_differs) {
    finding.notes.push_back(delay_after_filters_of(axis));
    finding.notes.push_back(delay_after_filters_of(other));
  }
  if (on_at_start(pair.master.delay) != on_at_start(pair.slave.delay)) {
    DelayedAxis const& on = on_at_start(pair.master.delay) ? pair.master : pair.slave;
    bool const is_guard = on.delay.kernel->family == machine::KernelFamily::guard;
    SentenceRef const sentence = is_guard ? says::guard_on_at_start : says::on_at_start;
    finding.notes.push_back({sentence, {{"axis", on.axis.name}}});
  }
  return finding;
}

}  // namespace axisc::validator::checks
