#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/position_control_words.hpp"
#include "validator/views/position_control_view.hpp"

namespace axisc::validator::checks::ax3036::says {

constexpr Sentence headline{"at {frequency} Hz the mode `{mode}` responds too late",
                            "bei {frequency} Hz reagiert der Modus `{mode}` zu spät"};
constexpr Sentence label{
    "the dead time shifts the phase by {degrees}°: the vibration may be amplified instead of damped",
    "die Totzeit verschiebt die Phase um {degrees}°: die Schwingung kann verstärkt statt gedämpft werden"};
constexpr Sentence limit_indirect{
    "{p_axis}: at most 45° of two cycles, f ≤ 1/(16 T) = {limit} Hz at T = {cycle}, for `INDIRECT`",
    "{p_axis}: höchstens 45° durch zwei Zyklen, f ≤ 1/(16 T) = {limit} Hz bei T = {cycle}, für `INDIRECT`"};
constexpr Sentence limit_set_point{
    "{p_axis}: at most 45° of one cycle, f ≤ 1/(8 T) = {limit} Hz at T = {cycle}, for `SET_POINT`",
    "{p_axis}: höchstens 45° durch einen Zyklus, f ≤ 1/(8 T) = {limit} Hz bei T = {cycle}, für `SET_POINT`"};
constexpr Sentence help_indirect{"`SET_POINT` has half the dead time; `DIRECT` simulates nothing",
                                 "`SET_POINT` hat die halbe Totzeit; `DIRECT` simuliert nichts"};
constexpr Sentence help_set_point{"`DIRECT` simulates nothing and has no such dead time",
                                  "`DIRECT` simuliert nichts und hat diese Totzeit nicht"};

}  // namespace axisc::validator::checks::ax3036::says

namespace axisc::validator::checks::ax3036 {
namespace {

/// NC cycles between the vibration and the velocity that answers it.
double dead_cycles(machine::StageMode mode) {
  switch (mode) {
    case machine::StageMode::direct: return 0;
    case machine::StageMode::indirect: return 2;
    case machine::StageMode::set_point: return 1;
  }
  return 0;
}

void ipc_phase_lag(AxisContext const& axis, Report& report) {
  constexpr double cycles_per_eighth_of_a_period = 8;
  for (StageView const& stage : axis.position_control.active_stages()) {
    double const cycles = dead_cycles(*stage.active_mode());
    auto const filter = stage.bandpass();
    if (cycles == 0 || !filter || !configured(filter->frequency)) continue;
    double const periods = axis.cycle_time.periods_in<double>({filter->frequency.value.number}) * cycles;
    if (periods * cycles_per_eighth_of_a_period <= 1) continue;
    double const limit = 1 / (cycles_per_eighth_of_a_period * cycles * axis.cycle_time.seconds());
    std::string const mode = symbol_word(stage.mode);
    Finding& finding =
        report.add(filter->frequency,
                   {says::headline, {{"frequency", number(filter->frequency.value.number)}, {"mode", mode}}});
    finding.label = Message{says::label, {{"degrees", format_rounded(periods * 360, 3)}}};
    finding.notes.push_back({cycles == 2 ? says::limit_indirect : says::limit_set_point,
                             {{"p_axis", parameter_number(filter->frequency)},
                              {"limit", format_rounded(limit, 6)},
                              {"cycle", microseconds(axis.cycle_time.microseconds())}}});
    relate_mode(finding, stage);
    finding.help.push_back({cycles == 2 ? says::help_indirect : says::help_set_point, {}});
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters = "ipc.stage[].filter.fg_f0 ipc.stage[].filter[].fg_f0 ipc.stage[].mode ipc.enable",
    .needs = Needs::cycle_time,
    .check = ipc_phase_lag,
};

}  // namespace axisc::validator::checks::ax3036
