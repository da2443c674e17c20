#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/group_delays.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::validator::says {

constexpr Sentence headline{
    R"(gantry "{master}"/"{slave}": the filters of master and slave are {cycles} cycles ({milliseconds} ms) apart)",
    "Gantry „{master}“/„{slave}“: die Filter von Master- und Slaveachse liegen {cycles} Zyklen "
    "({milliseconds} ms) "
    "auseinander"};
constexpr Sentence headline_same_delay{
    R"(gantry "{master}"/"{slave}": master and slave have different filters)",
    "Gantry „{master}“/„{slave}“: Master- und Slaveachse haben verschiedene Filter"};
constexpr Sentence skew{
    "at the master's `{parameter}` ({p_axis}), {velocity}, the portal skews by {skew} mm",
    "bei `{parameter}` der Masterachse ({p_axis}), {velocity}, steht das Portal um {skew} mm schief"};
constexpr Sentence same_delay{
    "their delays agree, so the portal skews only while it accelerates",
    "die Verzögerungen stimmen überein; das Portal steht nur beim Beschleunigen schief"};
constexpr Sentence on_at_start{
    "at start-up the linear-phase filter works in \"{axis}\" alone (`filter_fir.enable`)",
    "beim Hochlauf wirkt der linearphasige Filter nur in „{axis}“ (`filter_fir.enable`)"};
constexpr Sentence help{"configure the same filters in master and slave",
                        "in Master- und Slaveachse dieselben Filter konfigurieren"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
namespace {

// Delays that are computed in two ways may differ by rounding.
constexpr double rounding = 1e-6;

struct Pair {
  DelayedAxis const& master;
  DelayedAxis const& slave;
};

bool on_at_start(AxisDelay const& delay) {
  return delay.kernel && delay.kernel->on_at_start;
}

/// Of the filters that work from start-up.
double delay_at_start(DelayedAxis const& axis) {
  double cycles = axis.delay.cycles;
  bool const off = axis.delay.kernel && !axis.delay.kernel->on_at_start;
  if (off) cycles -= axis.delay.shares.back().cycles;
  return cycles;
}

/// The largest that start-up or `#FILTER` may bring about.
double difference(Pair pair) {
  double const configured = std::abs(pair.master.delay.cycles - pair.slave.delay.cycles);
  return std::max(configured, std::abs(delay_at_start(pair.master) - delay_at_start(pair.slave)));
}

/// Filters in series may be exchanged.
bool respond_alike(Pair pair) {
  AxisDelay const& master = pair.master.delay;
  AxisDelay const& slave = pair.slave.delay;
  bool const same_kernel = master.kernel.has_value() == slave.kernel.has_value() &&
                           (!master.kernel || master.kernel->specification == slave.kernel->specification);
  return same_kernel && on_at_start(master) == on_at_start(slave) &&
         std::is_permutation(master.filters.begin(), master.filters.end(), slave.filters.begin(),
                             slave.filters.end());
}

/// The axis that has the filter that makes the difference, the slave if in doubt, and that filter.
struct Cause {
  DelayedAxis const& axis;
  DelayShare const& filter;
};

std::optional<Cause> cause_of(Pair pair) {
  DelayShare const* const of_slave = largest_difference(pair.slave.delay, pair.master.delay);
  DelayShare const* const of_master = largest_difference(pair.master.delay, pair.slave.delay);
  bool const slave_is_longer = pair.slave.delay.cycles >= pair.master.delay.cycles;
  if (of_slave != nullptr && (slave_is_longer || of_master == nullptr)) return Cause{pair.slave, *of_slave};
  if (of_master != nullptr) return Cause{pair.master, *of_master};
  return std::nullopt;
}

void add_skew(Finding& finding, LoadedAxis const& master, double seconds) {
  EffectiveValue const& limit = master.merged.values.at("getriebe[].dynamik.vb_max");
  if (limit.unusable || master.type != machine::AxisType::translatory) return;
  double const velocity = limit.value.number / 1000;
  finding.notes.push_back({says::skew,
                           {{"parameter", parameter_name(limit)},
                            {"p_axis", parameter_number(limit)},
                            {"velocity", format_rounded(velocity, 4) + " mm/s"},
                            {"skew", format_rounded(velocity * seconds, 3)}}});
}

void check_pair(Pair pair, design::CycleTime cycle_time, Report& report) {
  double const cycles = difference(pair);
  if (cycles < rounding && respond_alike(pair)) return;
  auto const cause = cause_of(pair);
  if (!cause) return;
  bool const apart = cycles >= rounding;
  double const seconds = cycles * cycle_time.seconds();
  report.axis = cause->axis.axis.name;
  Finding& finding = report.add(*cause->filter.cause, {apart ? says::headline : says::headline_same_delay,
                                                       {{"master", pair.master.axis.name},
                                                        {"slave", pair.slave.axis.name},
                                                        {"cycles", cycles_text(cycles)},
                                                        {"milliseconds", format_rounded(seconds * 1e3, 4)}}});
  finding.label = delay_of(cause->axis);
  finding.notes.push_back(delay_of(&cause->axis == &pair.slave ? pair.master : pair.slave));
  if (on_at_start(pair.master.delay) != on_at_start(pair.slave.delay)) {
    DelayedAxis const& on = on_at_start(pair.master.delay) ? pair.master : pair.slave;
    finding.notes.push_back({says::on_at_start, {{"axis", on.axis.name}}});
  }
  if (apart) {
    add_skew(finding, pair.master.axis, seconds);
  } else {
    finding.notes.push_back({says::same_delay, {}});
  }
  finding.help.push_back({says::help, {}});
}

void gantry_filters_differ(MachineContext const& context, Report& report) {
  auto const delayed = [&](std::size_t index) -> std::optional<DelayedAxis> {
    LoadedAxis const& axis = context.machine.axes[index];
    auto delay = axis_delay(axis.merged.values, context.cycle_time);
    if (!delay) return std::nullopt;
    return DelayedAxis{axis, *std::move(delay)};
  };
  for (LoadedGantry const& gantry : context.machine.gantries) {
    auto const master = delayed(gantry.master);
    if (!master) continue;
    for (std::size_t const index : gantry.slaves) {
      auto const slave = delayed(index);
      if (slave) check_pair({*master, *slave}, context.cycle_time, report);
    }
  }
}

}  // namespace

extern constinit Rule const ax4021{
    .code = Code{4021},
    .name = "gantry-filters-differ",
    .parameters = "filter[].* filter_fir.* vib_guard.* kenngr.achs_mode kenngr.gantry_ax_nr",
    .needs = Needs::cycle_time,
    .check = gantry_filters_differ,
};

}  // namespace axisc::validator::checks
