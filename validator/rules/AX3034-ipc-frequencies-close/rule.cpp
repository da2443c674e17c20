#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/views/position_control_view.hpp"

#include <cmath>

namespace axisc::validator::checks::ax3034::says {

constexpr Sentence headline{
    "{frequency} Hz lies within the bandwidth of {others}: the stages influence each other",
    "{frequency} Hz liegt in der Bandbreite von {others}: die Stufen beeinflussen sich gegenseitig"};
constexpr Sentence other{"{frequency} Hz, bandwidth {width} Hz", "{frequency} Hz, Bandbreite {width} Hz"};
constexpr Sentence limit{
    "bandwidth = fg_f0 / q_factor; stages are separate where |f1 - f2| ≥ f1 / (2 q1) + f2 / (2 q2)",
    "Bandbreite = fg_f0 / q_factor; Stufen sind getrennt, wo |f1 - f2| ≥ f1 / (2 q1) + f2 / (2 q2)"};
constexpr Sentence help{"raise `q_factor`, or use one stage for both frequencies",
                        "`q_factor` erhöhen, oder eine Stufe für beide Frequenzen verwenden"};

}  // namespace axisc::validator::checks::ax3034::says

namespace axisc::validator::checks::ax3034 {
namespace {

/// The band that a stage damps.
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

void ipc_frequencies_close(AxisContext const& axis, Report& report) {
  auto const bands = bands_of(axis);
  for (Band const& band : bands) {
    std::vector<Related> earlier;
    Wording frequencies;
    for (Band const& other : bands) {
      bool const is_earlier = *other.frequency.value_place() < *band.frequency.value_place();
      if (!is_earlier || !disturb(other, band)) continue;
      Wording const frequency = number(other.centre);
      frequencies += (frequencies.empty() ? "" : ", ") + frequency + " Hz";
      earlier.push_back(
          {*other.frequency.value_place(),
           {says::other, {{"frequency", frequency}, {"width", format_rounded(2 * other.half_width, 4)}}}});
    }
    if (earlier.empty()) continue;
    Finding& finding = report.add(
        band.frequency, {says::headline, {{"frequency", number(band.centre)}, {"others", frequencies}}});
    finding.label = Message{
        says::other, {{"frequency", number(band.centre)}, {"width", format_rounded(2 * band.half_width, 4)}}};
    finding.notes.push_back({says::limit, {}});
    finding.help.push_back({says::help, {}});
    finding.related = std::move(earlier);
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters =
        "ipc.stage[].filter.fg_f0 ipc.stage[].filter[].fg_f0 ipc.stage[].filter.q_factor "
        "ipc.stage[].filter[].q_factor ipc.stage[].mode ipc.enable",
    .check = ipc_frequencies_close,
};

}  // namespace axisc::validator::checks::ax3034
