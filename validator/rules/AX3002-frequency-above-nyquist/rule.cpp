#include "validator/engine/rule.hpp"

#include "validator/rules/characteristic_frequency.hpp"
#include "validator/rules/control_numbers.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

// Message numbers of the control.
constexpr std::string_view setpoint_refused = "50557";
constexpr std::string_view position_controller_refused = "70420";

void frequency_above_nyquist(AxisContext const& axis, Report& report) {
  double const nyquist = axis.cycle_time.nyquist().value;
  for (CharacteristicFrequency const& found : characteristic_frequencies(axis)) {
    if (found.frequency.value.number < nyquist) continue;
    std::string const limit = number(nyquist);
    Finding& finding =
        report.add(found.anchor,
                   {Text::ax3002, {{"frequency", number(found.frequency.value.number)}, {"limit", limit}}});
    finding.label = Message{Text::ax3002_label,
                            {{"limit", limit}, {"cycle", microseconds(axis.cycle_time.microseconds())}}};
    finding.notes.push_back(
        {Text::ax3002_limit,
         {{"p_axis", parameter_number(found.frequency)}, {"limit", limit}, {"user", found.user}}});
    note_default(finding, found.frequency);
    react(finding, found.filtering == Filtering::setpoint ? setpoint_refused : position_controller_refused,
          {Text::filter_reaction_refused, {}});
  }
}

}  // namespace

extern constinit Rule const ax3002{
    .code = Code{3002},
    .name = "frequency-above-nyquist",
    .control = control_numbers<setpoint_refused, position_controller_refused>,
    .needs = Needs::cycle_time,
    .check = frequency_above_nyquist,
};

}  // namespace axisc::validator::checks
