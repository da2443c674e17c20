#include "validator/engine/rule.hpp"

#include "validator/rules/characteristic_frequency.hpp"
#include "validator/rules/control_numbers.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/sentences.hpp"

namespace axisc::validator::checks::ax3002::says {

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

}  // namespace axisc::validator::checks::ax3002::says

namespace axisc::validator::checks::ax3002 {
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

Message headline(double frequency, design::CycleTime cycle_time) {
  return {says::headline, {{"frequency", number(frequency)}, {"limit", number(cycle_time.nyquist().value)}}};
}

void describe(Finding& finding, double frequency, std::string const& parameter,
              design::CycleTime cycle_time) {
  double const nyquist = cycle_time.nyquist().value;
  Wording const limit = number(nyquist);
  finding.label =
      Message{says::label, {{"limit", limit}, {"cycle", microseconds(cycle_time.microseconds())}}};
  double const hertz = frequency / 1000;
  if (hertz >= 1 && hertz < nyquist) {
    finding.help.push_back(
        {says::help_millihertz,
         {{"value", number(frequency)}, {"parameter", parameter}, {"hertz", number(hertz)}}});
  } else {
    finding.help.push_back({says::help_lower, {{"limit", limit}}});
  }
}

void frequency_above_nyquist(AxisContext const& axis, Report& report) {
  double const nyquist = axis.cycle_time.nyquist().value;
  for (CharacteristicFrequency const& found : characteristic_frequencies(axis)) {
    double const frequency = found.frequency.value.number;
    if (frequency < nyquist) continue;
    Finding& finding = report.add(found.anchor, headline(frequency, axis.cycle_time));
    finding.notes.push_back(
        {says::limit,
         {{"p_axis", parameter_number(found.frequency)}, {"limit", number(nyquist)}, {"user", found.user}}});
    note_default(finding, found.frequency);
    describe(finding, frequency, parameter_name(found.frequency), axis.cycle_time);
    bool const stops = found.filtering == Filtering::distance_control;
    react(finding, message_of(found.filtering),
          {stops ? says::axis_stops : validator::says::filter_reaction_refused, {}});
  }
}

/// Distance control of a channel: all lines are in one list, as others that it is used with are not known.
void frequency_above_nyquist_in_list(ListContext const& context, Report& report) {
  if (context.list.kind != configuration::ListKind::channel || !context.cycle_time) return;
  LineValues const& lines = context.list.line_values;
  auto const line_of = [&](std::string const& name) -> std::optional<std::uint32_t> {
    auto const found = context.list.catalogue.find("dist_ctrl[0]." + name);
    std::uint32_t const last = found.row != nullptr ? lines.last_of(found.slot) : 0;
    if (last == 0 || lines[last - 1].status != ReadingStatus::value) return std::nullopt;
    return last - 1;
  };
  auto const frequency = line_of("low_pass_filter_fg_f0");
  auto const enable = line_of("low_pass_filter_enable");
  auto const type = line_of("filter_type");
  bool const is_used =
      (enable && lines[*enable].value.number != 0) || (type && lines[*type].value.text == "LOWPASS");
  if (!frequency || !is_used) return;
  double const value = lines[*frequency].value.number;
  if (value < context.cycle_time->nyquist().value) return;
  schema::Slot const slot = *lines.slot(*frequency);
  schema::Parameter const& row = context.list.catalogue.parameter_of(slot);
  Finding& finding = report.add(place_of(context, context.list.tree.assignments[*frequency].value), row, slot,
                                headline(value, *context.cycle_time));
  describe(finding, value, schema::slot_name(row, slot), *context.cycle_time);
  react(finding, distance_control_refused, {says::axis_stops, {}});
}

}  // namespace

extern constinit Rule const rule{
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
    .list_check = frequency_above_nyquist_in_list,
};

}  // namespace axisc::validator::checks::ax3002
