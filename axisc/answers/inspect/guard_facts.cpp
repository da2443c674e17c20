#include "axisc/answers/inspect/inspect_parts.hpp"
#include "axisc/answers/labels.hpp"
#include "design/kernels/vibration_guard.hpp"
#include "diagnostics/format_number.hpp"

namespace axisc::says {

constexpr Sentence impulses{"impulses", "Impulse"};
constexpr Sentence left{"left at {frequency}", "Rest bei {frequency}"};
constexpr Sentence band{"at most 5 % left", "höchstens 5 % Rest"};
constexpr Sentence from_to{"from {from} to {to} (configured/actual {lowest} … +{highest})",
                           "von {from} bis {to} (eingestellt/tatsächlich {lowest} … +{highest})"};
constexpr Sentence nowhere{"at no frequency", "bei keiner Frequenz"};
constexpr Sentence reading{"the shapers are a reading of the manual",
                           "die Former sind eine Lesart des Handbuchs"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

Section guard_section(image::ImageKernel const& kernel, design::CycleTime cycle_time) {
  auto const& guard = kernel.specification;
  Numbers times{.values = {}, .unit = Unit::millisecond, .digits = Digits::significant(4)};
  Numbers amplitudes{.values = {}, .unit = Unit::percent, .digits = Digits::significant(4)};
  for (auto const& impulse : design::guard_impulses(guard)) {
    times.values.push_back(impulse.time.value / 1000);
    amplitudes.values.push_back(100 * impulse.amplitude);
  }
  Wording shown_impulses;
  for (std::size_t i = 0; i < times.values.size(); ++i) {
    shown_impulses += Wording(i == 0 ? "" : ", ") + format_rounded(times.values[i], 4) + " ms " +
                      format_rounded(amplitudes.values[i], 3) + " %";
  }
  auto const residual =
      rounded(100 * design::residual_at_design(kernel.design, guard, cycle_time), Unit::percent);
  auto const band = design::robustness(kernel.design, guard, cycle_time);
  Value shown_band = Words(says::nowhere);
  if (band) {
    shown_band = Words(says::from_to, {{"from", rounded(band->from.value, Unit::hertz)},
                                       {"to", rounded(band->to.value, Unit::hertz)},
                                       {"lowest", rounded(100 * band->lowest, Unit::percent)},
                                       {"highest", rounded(100 * band->highest, Unit::percent)}});
  }
  auto const of_band = [&](double design::Robustness::*member) {
    return value_if(band.has_value(), exact(band ? 100 * (*band).*member : 0, Unit::percent));
  };
  auto const frequency = exact(guard.frequency.value, Unit::hertz);
  Facts facts{{data("mode", guard.order),
               data("frequency_hz", frequency),
               data("damping", exact(guard.quality)),
               data("impulses_ms", std::move(times)),
               data("impulses_percent", std::move(amplitudes)),
               shown(says::impulses, std::move(shown_impulses)),
               {"residual_percent", Words(says::left, {{"frequency", frequency}}), residual},
               shown(says::band, std::move(shown_band)),
               data("interval_lowest_percent", of_band(&design::Robustness::lowest)),
               data("interval_highest_percent", of_band(&design::Robustness::highest))}};
  return {.key = "vibration_guard", .title = {}, .blocks = {std::move(facts), Paragraph{says::reading}}};
}

}  // namespace axisc
