#include "validator/engine/rule.hpp"

#include "validator/rules/control_numbers.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/views/feedforward_view.hpp"

#include <cmath>
#include <string_view>

namespace axisc::validator::checks::ax3045::says {

constexpr Sentence headline{"the delay must be shorter than 6 NC cycles",
                            "die Verzögerung muss kürzer als 6 NC-Zyklen sein"};
constexpr Sentence older_headline{
    "older builds of the control take 0 for a delay of one NC cycle or more",
    "ältere Versionen der Steuerung setzen für eine Verzögerung ab einem NC-Zyklus 0 ein"};
constexpr Sentence limit{"{p_axis}: 0 ≤ {parameter} < 6 T = {limit}",
                         "{p_axis}: 0 ≤ {parameter} < 6 T = {limit}"};
constexpr Sentence older_limit{
    "the parameter's page says < 6 T, the pages of the messages and older manuals < T; the build that "
    "changed it is not documented",
    "die Beschreibung des Parameters nennt < 6 T, die der Meldungen und ältere Handbücher < T; ab welcher "
    "Version ist nicht dokumentiert"};
constexpr Sentence reaction{"it takes 0: no delay", "sie setzt 0 ein: keine Verzögerung"};
constexpr Sentence help{"`{parameter} {longest}` is the longest here",
                        "`{parameter} {longest}` ist hier die längste"};
constexpr Sentence help_older{"less than {cycle} suits every build",
                              "weniger als {cycle} ist in jeder Version erlaubt"};

}  // namespace axisc::validator::checks::ax3045::says

namespace axisc::validator::checks::ax3045 {
namespace {

constexpr std::string_view refuses_velocity_time = "70349";
constexpr std::string_view refuses_acceleration_time = "70348";

void check(EffectiveValue const& time, std::string_view refusal, AxisContext const& axis, Report& report) {
  if (time.unusable || !configured(time)) return;
  double const cycles = axis.cycle_time.cycles({time.value.number});
  if (cycles < 1) return;
  bool const is_refused = cycles >= refused_delay_cycles;
  Finding& finding = report.add(time, {is_refused ? says::headline : says::older_headline, {}});
  if (!is_refused) finding.severity = Severity::note;
  finding.label = time_in_cycles(time.value.number, axis.cycle_time);
  if (is_refused) {
    finding.notes.push_back(
        {says::limit,
         {{"p_axis", parameter_number(time)},
          {"parameter", parameter_name(time)},
          {"limit", microseconds(refused_delay_cycles * axis.cycle_time.microseconds())}}});
    double const longest = std::ceil(refused_delay_cycles * axis.cycle_time.microseconds()) - 1;
    finding.help.push_back({says::help, {{"parameter", parameter_name(time)}, {"longest", number(longest)}}});
    react(finding, refusal, {says::reaction, {}}, "0");
  } else {
    finding.notes.push_back({says::older_limit, {}});
    finding.help.push_back({says::help_older, {{"cycle", microseconds(axis.cycle_time.microseconds())}}});
  }
}

void feedforward_delay_too_long(AxisContext const& axis, Report& report) {
  check(axis.values.at("vorsteuer.velocity_delay_time"), refuses_velocity_time, axis, report);
  check(axis.values.at("vorsteuer.acceleration_delay_time"), refuses_acceleration_time, axis, report);
  check(axis.values.at("vorsteuer.jerk_delay_time"), refuses_acceleration_time, axis, report);
}

}  // namespace

extern constinit Rule const rule{
    .control = control_numbers<refuses_acceleration_time, refuses_velocity_time>,
    .parameters = "vorsteuer.velocity_delay_time vorsteuer.acceleration_delay_time vorsteuer.jerk_delay_time",
    .needs = Needs::cycle_time,
    .check = feedforward_delay_too_long,
};

}  // namespace axisc::validator::checks::ax3045
