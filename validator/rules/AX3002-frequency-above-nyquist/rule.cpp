#include "validator/engine/rule.hpp"

#include "validator/rules/characteristic_frequency.hpp"
#include "validator/rules/control_numbers.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/sentences.hpp"

namespace axisc::validator::says {

constexpr Sentence headline{"{frequency} Hz is not below half the sampling rate, {limit} Hz",
                            "{frequency} Hz liegt nicht unter der halben Abtastrate von {limit} Hz"};
constexpr Sentence label{"0.5/T = {limit} Hz at T = {cycle}", "0,5/T = {limit} Hz bei T = {cycle}"};
constexpr Sentence help_millihertz{"the value is in Hz: {value} mHz are `{parameter} {hertz}`",
                                   "der Wert gilt in Hz: {value} mHz sind `{parameter} {hertz}`"};
constexpr Sentence help_lower{
    "choose a frequency below {limit} Hz; setpoints that come once per cycle hold nothing above it",
    "eine Frequenz unter {limit} Hz wählen; Sollwerte, die einmal je Zyklus kommen, enthalten nichts "
    "darüber"};
constexpr Sentence axis_stops{"it cannot design the filter and stops the axis",
                              "sie kann den Filter nicht entwerfen und hält die Achse an"};
constexpr Sentence limit{"{p_axis}: 0 < f < 0.5/T = {limit} Hz for `{user}`",
                         "{p_axis}: 0 < f < 0,5/T = {limit} Hz für `{user}`"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
namespace {

// Message numbers of the control.
constexpr std::string_view setpoint_refused = "50557";
constexpr std::string_view guard_refused = "50913";
constexpr std::string_view position_controller_refused = "70420";
constexpr std::string_view distance_control_refused = "70458";

std::string_view message_of(Filtering filtering) {
  switch (filtering) {
    case Filtering::setpoint: return setpoint_refused;
    case Filtering::vibration_guard: return guard_refused;
    case Filtering::position_controller: return position_controller_refused;
    case Filtering::distance_control: return distance_control_refused;
  }
  return {};
}

void frequency_above_nyquist(AxisContext const& axis, Report& report) {
  double const nyquist = axis.cycle_time.nyquist().value;
  for (CharacteristicFrequency const& found : characteristic_frequencies(axis)) {
    if (found.frequency.value.number < nyquist) continue;
    Wording const limit = number(nyquist);
    Finding& finding =
        report.add(found.anchor,
                   {says::headline, {{"frequency", number(found.frequency.value.number)}, {"limit", limit}}});
    finding.label =
        Message{says::label, {{"limit", limit}, {"cycle", microseconds(axis.cycle_time.microseconds())}}};
    finding.notes.push_back(
        {says::limit,
         {{"p_axis", parameter_number(found.frequency)}, {"limit", limit}, {"user", found.user}}});
    note_default(finding, found.frequency);
    double const hertz = found.frequency.value.number / 1000;
    if (hertz >= 1 && hertz < nyquist) {
      finding.help.push_back({says::help_millihertz,
                              {{"value", number(found.frequency.value.number)},
                               {"parameter", parameter_name(found.frequency)},
                               {"hertz", number(hertz)}}});
    } else {
      finding.help.push_back({says::help_lower, {{"limit", limit}}});
    }
    bool const stops = found.filtering == Filtering::distance_control;
    react(finding, message_of(found.filtering),
          {stops ? says::axis_stops : says::filter_reaction_refused, {}});
  }
}

}  // namespace

extern constinit Rule const ax3002{
    .control = control_numbers<setpoint_refused, guard_refused, position_controller_refused,
                               distance_control_refused>,
    .parameters =
        "filters[].fg_f0 filters[].type filters[].enable filters[].order filters[].prototype filter_fir.fcut "
        "filter_fir.type vib_guard.freq vib_guard.mode ipc.stage[].filter.fg_f0 ipc.stage[].filter[].fg_f0 "
        "ipc.stage[].mode ipc.enable kenngr.distc.low_pass_filter_fg_f0 kenngr.distc.low_pass_filter_enable "
        "kenngr.distc.filter_type kenngr.dist_ctrl[].low_pass_filter_fg_f0 "
        "kenngr.dist_ctrl[].low_pass_filter_enable kenngr.dist_ctrl[].filter_type",
    .needs = Needs::cycle_time,
    .check = frequency_above_nyquist,
};

}  // namespace axisc::validator::checks
