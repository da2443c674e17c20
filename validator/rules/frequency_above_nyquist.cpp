#include "validator/rules/characteristic_frequency.hpp"
#include "validator/rules/filter_checks.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {

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
    react(finding, found.nyquist_message, {Text::filter_reaction_refused, {}});
  }
}

}  // namespace axisc::validator::checks
