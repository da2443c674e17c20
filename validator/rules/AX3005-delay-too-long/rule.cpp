#include "validator/engine/rule.hpp"

#include "validator/rules/control_numbers.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/sentences.hpp"

#include <cmath>

namespace axisc::validator::checks::ax3005::says {

constexpr Sentence headline{"the delay must be shorter than 6 NC cycles",
                            "die Verzögerung muss kürzer als 6 NC-Zyklen sein"};
constexpr Sentence limit{"{p_axis}: 0 ≤ time_constant < 6 T = {limit} ({milliseconds}) for `TIME_DELAY`",
                         "{p_axis}: 0 ≤ time_constant < 6 T = {limit} ({milliseconds}) für `TIME_DELAY`"};
constexpr Sentence help_longest{"`{parameter} {longest}` is the longest here",
                                "`{parameter} {longest}` ist hier die längste"};
constexpr Sentence help_fir{"`filter_fir.type 4` delays by up to 100 cycles",
                            "`filter_fir.type 4` verzögert um bis zu 100 Zyklen"};

}  // namespace axisc::validator::checks::ax3005::says

namespace axisc::validator::checks::ax3005 {
namespace {

constexpr double shortest_refused_cycles =
    design::kind_of(design::FilterType::time_delay).time_constant->limit;

void delay_too_long(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  EffectiveValue const& time = filter.time_constant;
  if (filter.type_unusable() || time.unusable) return;
  if (filter.standard_type != design::FilterType::time_delay) return;
  if (!filter.active() && !configured(time)) return;
  design::CycleTime const cycle_time = context.axis.cycle_time;
  double const cycles = cycle_time.cycles({time.value.number});
  if (cycles < shortest_refused_cycles) return;

  double const limit = shortest_refused_cycles * cycle_time.microseconds();
  Finding& finding = report.add(filter.anchor(time), {says::headline, {}});
  finding.label = time_in_cycles(time.value.number, cycle_time);
  finding.notes.push_back({says::limit,
                           {{"p_axis", parameter_number(time)},
                            {"limit", microseconds(limit)},
                            {"milliseconds", milliseconds(limit)}}});
  note_default(finding, time);
  relate_type(finding, filter);
  finding.help.push_back(
      {says::help_longest, {{"parameter", parameter_name(time)}, {"longest", number(std::ceil(limit) - 1)}}});
  if (filter.port == FilterPort::setpoint) finding.help.push_back({says::help_fir, {}});
  react(finding, time_constant_message(context), {validator::says::filter_reaction_off, {}});
}

}  // namespace

extern constinit Rule const rule{
    .control = control_numbers<path_refuses_time, spindle_refuses_time, position_controller_refuses_time>,
    .parameters = "filters[].time_constant filters[].type filters[].enable filters[].order",
    .needs = Needs::cycle_time,
    .check = delay_too_long,
};

}  // namespace axisc::validator::checks::ax3005
