// AX3034 and AX3036: frequencies that disturb each other, or that come too late.
#include "diagnostics/format_number.hpp"
#include "validator/position_control_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/position_control_checks.hpp"

#include <cmath>

namespace axisc::validator::checks {
namespace {

/// What a stage damps.
struct Band {
  StageView stage;
  EffectiveValue const& frequency;
  double centre = 0;
  double half_width = 0;
};

std::vector<Band> bands_of(AxisContext const& axis) {
  std::vector<Band> bands;
  for (StageView const& stage : axis.position_control.active_stages()) {
    auto const filter = stage.bandpass();
    if (!filter || !configured(filter->frequency) || !configured(filter->quality)) continue;
    double const centre = filter->frequency.value.number;
    double const quality = filter->quality.value.number;
    if (!(centre > 0) || !(quality > 0) || !filter->frequency.value_place()) continue;
    bands.push_back({stage, filter->frequency, centre, centre / (2 * quality)});
  }
  return bands;
}

bool disturb(Band const& left, Band const& right) {
  return std::abs(left.centre - right.centre) < left.half_width + right.half_width;
}

/// NC cycles between the vibration and the velocity that answers it.
double dead_cycles(StageMode mode) {
  switch (mode) {
    case StageMode::direct:
      return 0;
    case StageMode::indirect:
      return 2;
    case StageMode::set_point:
      return 1;
  }
  return 0;
}

}  // namespace

void ipc_frequencies_close(AxisContext const& axis, Report& report) {
  auto const bands = bands_of(axis);
  for (Band const& band : bands) {
    std::vector<Related> earlier;
    std::string frequencies;
    for (Band const& other : bands) {
      bool const is_earlier = *other.frequency.value_place() < *band.frequency.value_place();
      if (!is_earlier || !disturb(other, band)) continue;
      std::string const frequency = number(other.centre);
      frequencies.append(frequencies.empty() ? "" : ", ").append(frequency).append(" Hz");
      earlier.push_back({*other.frequency.value_place(),
                         {Text::ax3034_other,
                          {{"frequency", frequency}, {"width", format_rounded(2 * other.half_width, 4)}}}});
    }
    if (earlier.empty()) continue;
    Finding& finding = report.add(
        band.frequency, {Text::ax3034, {{"frequency", number(band.centre)}, {"others", frequencies}}});
    finding.label =
        Message{Text::ax3034_other,
                {{"frequency", number(band.centre)}, {"width", format_rounded(2 * band.half_width, 4)}}};
    finding.notes.push_back({Text::ax3034_limit, {}});
    finding.related = std::move(earlier);
  }
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
    if (stage.mode.value_place()) {
      finding.related.push_back({*stage.mode.value_place(), {Text::ipc_mode_here, {{"mode", mode}}}});
    }
    finding.help.push_back({cycles == 2 ? Text::ax3036_help_indirect : Text::ax3036_help_set_point, {}});
  }
}

}  // namespace axisc::validator::checks
