#include "validator/engine/rule.hpp"

#include "validator/rules/control_numbers.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/sentences.hpp"

#include <cmath>
#include <numbers>

namespace axisc::validator::checks::ax3004::says {

constexpr Sentence headline{"the time constant of `{type}` must be at least one NC cycle",
                            "die Zeitkonstante von `{type}` muss mindestens einen NC-Zyklus lang sein"};
constexpr Sentence limit{"{p_axis}: time_constant ≥ T = {limit} ({milliseconds}) for `{type}`",
                         "{p_axis}: time_constant ≥ T = {limit} ({milliseconds}) für `{type}`"};
constexpr Sentence help{"`{parameter} {shortest}` is the shortest; its cut-off frequency is {frequency} Hz",
                        "`{parameter} {shortest}` ist die kürzeste; ihre Grenzfrequenz ist {frequency} Hz"};

}  // namespace axisc::validator::checks::ax3004::says

namespace axisc::validator::checks::ax3004 {
namespace {

bool is_lag(FilterView const& filter) {
  if (!filter.standard_type) return false;
  auto const& time = design::kind_of(*filter.standard_type).time_constant;
  return time && time->meaning == design::TimeMeaning::lag;
}

void time_constant_below_cycle(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  EffectiveValue const& time = filter.time_constant;
  if (filter.type_unusable() || time.unusable || !is_lag(filter)) return;
  if (!filter.active() && !configured(time)) return;
  design::CycleTime const cycle_time = context.axis.cycle_time;
  double const cycles = cycle_time.cycles({time.value.number});
  if (cycles >= 1) return;

  Wording const cycle = microseconds(cycle_time.microseconds());
  std::string const type(filter.type_word());
  double const shortest = std::ceil(cycle_time.microseconds());
  double const cut_off = 1e6 / (2 * std::numbers::pi * shortest);
  Finding& finding = report.add(filter.anchor(time), {says::headline, {{"type", type}}});
  finding.label = time_in_cycles(time.value.number, cycle_time);
  finding.notes.push_back({says::limit,
                           {{"p_axis", parameter_number(time)},
                            {"limit", cycle},
                            {"milliseconds", milliseconds(cycle_time.microseconds())},
                            {"type", type}}});
  note_default(finding, time);
  relate_type(finding, filter);
  if (cycles * 1000 >= 1) {
    finding.help.push_back(
        {validator::says::milliseconds_meant,
         {{"value", number(time.value.number)},
          {"replacement", parameter_name(time) + " " + number(time.value.number * 1000)}}});
  }
  finding.help.push_back({says::help,
                          {{"parameter", parameter_name(time)},
                           {"shortest", number(shortest)},
                           {"frequency", number(std::round(cut_off))}}});
  react(finding, time_constant_message(context), {validator::says::filter_reaction_off, {}});
}

}  // namespace

extern constinit Rule const rule{
    .control = control_numbers<path_refuses_time, spindle_refuses_time, position_controller_refuses_time>,
    .parameters = "filters[].time_constant filters[].type filters[].enable filters[].order",
    .needs = Needs::cycle_time,
    .silenced_by = codes<3040>,
    .check = time_constant_below_cycle,
};

}  // namespace axisc::validator::checks::ax3004
