#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/views/position_control_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/position_control_words.hpp"

namespace axisc::validator::checks {
namespace {

/// NC cycles between the vibration and the velocity that answers it.
double dead_cycles(machine::StageMode mode) {
  switch (mode) {
    case machine::StageMode::direct:
      return 0;
    case machine::StageMode::indirect:
      return 2;
    case machine::StageMode::set_point:
      return 1;
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
                   {Text::ax3036, {{"frequency", number(filter->frequency.value.number)}, {"mode", mode}}});
    finding.label = Message{Text::ax3036_label, {{"degrees", format_rounded(periods * 360, 3)}}};
    finding.notes.push_back({cycles == 2 ? Text::ax3036_limit_indirect : Text::ax3036_limit_set_point,
                             {{"p_axis", parameter_number(filter->frequency)},
                              {"limit", format_rounded(limit, 6)},
                              {"cycle", microseconds(axis.cycle_time.microseconds())}}});
    relate_mode(finding, stage);
    finding.help.push_back({cycles == 2 ? Text::ax3036_help_indirect : Text::ax3036_help_set_point, {}});
  }
}

}  // namespace

extern constinit Rule const ax3036{
    .code = Code{3036},
    .name = "ipc-phase-lag",
    .severity = Severity::warning,
    .needs = Needs::cycle_time,
    .check = ipc_phase_lag,
};

}  // namespace axisc::validator::checks
