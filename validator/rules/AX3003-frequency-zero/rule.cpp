#include "validator/engine/rule.hpp"

#include "validator/rules/characteristic_frequency.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks::ax3003::says {

constexpr Sentence headline{"`{user}` cannot work at {frequency} Hz",
                            "`{user}` kann bei {frequency} Hz nicht arbeiten"};
constexpr Sentence label{"must be above 0 Hz", "muss über 0 Hz liegen"};
constexpr Sentence limit{"{p_axis}: 0 < f < 0.5/T = {limit} Hz at T = {cycle}",
                         "{p_axis}: 0 < f < 0,5/T = {limit} Hz bei T = {cycle}"};
constexpr Sentence reaction{"it raises the frequency to the lowest allowed one",
                            "sie hebt die Frequenz auf die kleinste zulässige an"};
constexpr Sentence help{"set the intended frequency; `enable 0` switches a filter off",
                        "die gewünschte Frequenz setzen; `enable 0` schaltet einen Filter ab"};

}  // namespace axisc::validator::checks::ax3003::says

namespace axisc::validator::checks::ax3003 {
namespace {

void frequency_zero(AxisContext const& axis, Report& report) {
  for (CharacteristicFrequency const& found : characteristic_frequencies(axis)) {
    if (found.frequency.value.number > 0) continue;
    // The guard's range begins at 1 Hz, that of the distance control at 0.
    if (found.filtering == Filtering::vibration_guard) continue;
    if (found.filtering == Filtering::distance_control) continue;
    Finding& finding = report.add(
        found.anchor,
        {says::headline, {{"frequency", number(found.frequency.value.number)}, {"user", found.user}}});
    finding.label = Message{says::label, {}};
    finding.notes.push_back({says::limit,
                             {{"p_axis", parameter_number(found.frequency)},
                              {"limit", number(axis.cycle_time.nyquist().value)},
                              {"cycle", microseconds(axis.cycle_time.microseconds())}}});
    finding.help.push_back({says::help, {}});
    react(finding, {says::reaction, {}});
  }
}

}  // namespace

extern constinit Rule const rule{
    .control = "110361",
    .parameters =
        "filters[].fg_f0 filters[].type filters[].enable filters[].order filters[].prototype filter_fir.fcut "
        "filter_fir.type ipc.stage[].filter.fg_f0 ipc.stage[].filter[].fg_f0 ipc.stage[].mode ipc.enable",
    .check = frequency_zero,
};

}  // namespace axisc::validator::checks::ax3003
