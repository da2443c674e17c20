#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/views/position_control_view.hpp"
#include "validator/rules/filter_words.hpp"

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

}  // namespace

extern constinit Rule const ax3034{
    .code = Code{3034},
    .name = "ipc-frequencies-close",
    .severity = Severity::warning,
    .check = ipc_frequencies_close,
};

}  // namespace axisc::validator::checks
