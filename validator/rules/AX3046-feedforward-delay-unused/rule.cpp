#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/views/drive.hpp"
#include "validator/views/feedforward_view.hpp"

#include <string_view>

namespace axisc::validator::checks::ax3046::says {

constexpr Sentence headline{"`{parameter}` has no effect", "`{parameter}` hat keine Wirkung"};
constexpr Sentence needs_quantity{"{p_axis}: acts only with {word} in P-AXIS-00223, which is {value} here",
                                  "{p_axis}: wirkt nur mit {word} in P-AXIS-00223; hier ist es {value}"};
constexpr Sentence needs_drive{"{p_axis}: acts only with PROFIDRIVE; the drive is \"{drive}\"",
                               "{p_axis}: wirkt nur mit PROFIDRIVE; der Antrieb ist „{drive}“"};
constexpr Sentence help_quantity{"add {word} to P-AXIS-00223, or remove the line",
                                 "{word} in P-AXIS-00223 ergänzen, oder die Zeile entfernen"};
constexpr Sentence help_drive{"remove the line, or correct the drive type",
                              "die Zeile entfernen, oder den Antriebstyp berichtigen"};

}  // namespace axisc::validator::checks::ax3046::says

namespace axisc::validator::checks::ax3046 {
namespace {

void check_quantity(std::string_view name, Feedforward quantity, std::string_view word,
                    AxisContext const& axis, Report& report) {
  EffectiveValue const& time = axis.values.at(name);
  if (time.unusable || !configured(time)) return;
  FeedforwardView const feedforward(axis.values);
  if (feedforward.quantities.unusable || feedforward.uses(quantity)) return;
  Finding& finding = report.add(time, {says::headline, {{"parameter", parameter_name(time)}}});
  finding.notes.push_back({says::needs_quantity,
                           {{"p_axis", parameter_number(time)},
                            {"word", std::string(word)},
                            {"value", symbol_word(feedforward.quantities)}}});
  finding.help.push_back({says::help_quantity, {{"word", std::string(word)}}});
}

void feedforward_delay_unused(AxisContext const& axis, Report& report) {
  check_quantity("vorsteuer.velocity_delay_time", Feedforward::added_velocity, "ADD_VEL", axis, report);
  check_quantity("vorsteuer.acceleration_delay_time", Feedforward::added_acceleration, "ADD_ACC", axis,
                 report);
  check_quantity("vorsteuer.jerk_delay_time", Feedforward::added_jerk, "ADD_JERK", axis, report);

  machine::DriveType const* const drive = stated_drive(axis.machine.axes[axis.index]);
  if (drive == nullptr || drive->number == machine::profidrive) return;
  for (std::string_view const name : {"vorsteuer.shift_time", "vorsteuer.timeconst_cmd_filter"}) {
    EffectiveValue const& time = axis.values.at(name);
    if (time.unusable || !configured(time)) continue;
    Finding& finding = report.add(time, {says::headline, {{"parameter", parameter_name(time)}}});
    finding.notes.push_back(
        {says::needs_drive, {{"p_axis", parameter_number(time)}, {"drive", drive_name(*drive)}}});
    finding.help.push_back({says::help_drive, {}});
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters =
        "vorsteuer.velocity_delay_time vorsteuer.acceleration_delay_time vorsteuer.jerk_delay_time "
        "vorsteuer.vorsteuerung vorsteuer.shift_time vorsteuer.timeconst_cmd_filter kenngr.antr_typ",
    .check = feedforward_delay_unused,
};

}  // namespace axisc::validator::checks::ax3046
