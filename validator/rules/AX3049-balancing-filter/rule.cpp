#include "validator/engine/rule.hpp"

#include "validator/rules/control_numbers.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/views/drive.hpp"

#include <cmath>
#include <string_view>

namespace axisc::validator::checks::ax3049::says {

constexpr Sentence wrong_drive{
    "the filter that balances feedforward is for PROFIDRIVE; the drive is \"{drive}\"",
    "den Filter, der die Vorsteuerung ausgleicht, gibt es für PROFIDRIVE; der Antrieb ist „{drive}“"};
constexpr Sentence too_short{
    "the time constant of the filter that balances feedforward is shorter than an NC cycle",
    "die Zeitkonstante des Filters, der die Vorsteuerung ausgleicht, ist kürzer als ein NC-Zyklus"};
constexpr Sentence limit_unknown{"the control reports it as too small; its limit is not documented",
                                 "die Steuerung meldet sie als zu klein; die Grenze ist nicht dokumentiert"};
constexpr Sentence help_off{"`{parameter} 0` switches the filter off",
                            "`{parameter} 0` schaltet den Filter ab"};
constexpr Sentence help_longer{"write at least {cycle}, or 0, which switches the filter off",
                               "mindestens {cycle} schreiben, oder 0, was den Filter abschaltet"};

}  // namespace axisc::validator::checks::ax3049::says

namespace axisc::validator::checks::ax3049 {
namespace {

constexpr std::string_view wrong_drive_number = "110486";
constexpr std::string_view too_short_number = "70355";

void balancing_filter(AxisContext const& axis, Report& report) {
  EffectiveValue const& time = axis.values.at("vorsteuer.timeconst_sym_filter");
  if (time.unusable || !(time.value.number > 0)) return;
  machine::DriveType const* const drive = stated_drive(axis.machine.axes[axis.index]);
  if (drive != nullptr && drive->number != machine::profidrive) {
    Finding& finding = report.add(time, {says::wrong_drive, {{"drive", drive_name(*drive)}}});
    finding.help.push_back({says::help_off, {{"parameter", parameter_name(time)}}});
    react(finding, wrong_drive_number, {validator::says::undocumented_reaction});
    return;
  }
  if (axis.cycle_time.cycles({time.value.number}) >= 1) return;
  Finding& finding = report.add(time, {says::too_short, {}});
  finding.severity = Severity::warning;
  finding.label = time_in_cycles(time.value.number, axis.cycle_time);
  finding.notes.push_back({says::limit_unknown, {}});
  finding.help.push_back(
      {says::help_longer, {{"cycle", microseconds(std::ceil(axis.cycle_time.microseconds()))}}});
  react(finding, too_short_number, {validator::says::undocumented_reaction});
}

}  // namespace

extern constinit Rule const rule{
    .control = control_numbers<too_short_number, wrong_drive_number>,
    .parameters = "vorsteuer.timeconst_sym_filter kenngr.antr_typ",
    .needs = Needs::cycle_time,
    .check = balancing_filter,
};

}  // namespace axisc::validator::checks::ax3049
