#include "validator/rules/unequal_filters.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/filter_words.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::validator::says {

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

/// The delay of the filters that work from start-up.
double delay_at_start(DelayedAxis const& axis) {
  double cycles = axis.delay.cycles;
  bool const off = axis.delay.kernel && !axis.delay.kernel->on_at_start;
  if (off) cycles -= axis.delay.shares.back().cycles;
  return cycles;
}

/// The largest difference that start-up or `#FILTER` may bring about.
double difference(AxisPair pair) {
  double const configured = std::abs(pair.master.delay.cycles - pair.slave.delay.cycles);
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

bool FilterDifference::is_apart() const {
  return cycles >= rounding;
}

std::optional<DelayedAxis> delayed_axis(MachineContext const& context, std::size_t index) {
  LoadedAxis const& axis = context.machine.axes[index];
  auto delay = axis_delay(axis.merged.values, context.cycle_time);
  if (!delay) return std::nullopt;
  return DelayedAxis{axis, *std::move(delay)};
}

std::optional<FilterDifference> compare_filters(AxisPair pair) {
  double const cycles = difference(pair);
  if (cycles < rounding && respond_alike(pair)) return std::nullopt;
  DelayShare const* const of_slave = largest_difference(pair.slave.delay, pair.master.delay);
  DelayShare const* const of_master = largest_difference(pair.master.delay, pair.slave.delay);
  bool const slave_is_longer = pair.slave.delay.cycles >= pair.master.delay.cycles;
  if (of_slave != nullptr && (slave_is_longer || of_master == nullptr)) {
    return FilterDifference{pair, cycles, pair.slave, *of_slave};
  }
  if (of_master != nullptr) return FilterDifference{pair, cycles, pair.master, *of_master};
  return std::nullopt;
}

Finding& report_difference(FilterDifference const& difference, SentenceRef headline,
                           MachineContext const& context, Report& report) {
  auto const& [pair, cycles, axis, filter] = difference;
  report.axis = axis.axis.name;
  Finding& finding = report.add(
      *filter.cause, {headline,
                      {{"master", pair.master.axis.name},
                       {"slave", pair.slave.axis.name},
                       {"cycles", cycles_text(cycles)},
                       {"milliseconds", format_rounded(cycles * context.cycle_time.seconds() * 1e3, 4)}}});
  finding.label = delay_of(axis);
  finding.notes.push_back(delay_of(&axis == &pair.slave ? pair.master : pair.slave));
  if (on_at_start(pair.master.delay) != on_at_start(pair.slave.delay)) {
    DelayedAxis const& on = on_at_start(pair.master.delay) ? pair.master : pair.slave;
    finding.notes.push_back({says::on_at_start, {{"axis", on.axis.name}}});
  }
  return finding;
}

}  // namespace axisc::validator::checks
