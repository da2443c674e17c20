#include "validator/engine/rule.hpp"

#include "validator/rules/characteristic_frequency.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

void frequency_zero(AxisContext const& axis, Report& report) {
  for (CharacteristicFrequency const& found : characteristic_frequencies(axis)) {
    if (found.frequency.value.number > 0) continue;
    Finding& finding = report.add(
        found.anchor,
        {Text::ax3003, {{"frequency", number(found.frequency.value.number)}, {"user", found.user}}});
    finding.label = Message{Text::ax3003_label, {}};
    finding.notes.push_back({Text::ax3003_limit,
                             {{"p_axis", parameter_number(found.frequency)},
                              {"limit", number(axis.cycle_time.nyquist().value)},
                              {"cycle", microseconds(axis.cycle_time.microseconds())}}});
    react(finding, {Text::ax3003_reaction, {}});
  }
}

}  // namespace

extern constinit Rule const ax3003{
    .code = Code{3003},
    .name = "frequency-zero",
    .control = "110361",
    .check = frequency_zero,
};

}  // namespace axisc::validator::checks
