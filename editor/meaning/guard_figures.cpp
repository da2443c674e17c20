#include "editor/meaning/guard_figures.hpp"

#include "design/kernels/vibration_guard.hpp"
#include "diagnostics/format_number.hpp"
#include "editor/reading/requests.hpp"
#include "validator/views/guard_view.hpp"

#include <vector>

namespace axisc::editor::says {

constexpr Sentence with_band{
    "mode {mode} at {frequency} Hz, delay {delay} ms, at most 5 % left from {from} to {to} Hz (a reading)",
    "Modus {mode} bei {frequency} Hz, Verzögerung {delay} ms, höchstens 5 % Rest von {from} bis {to} Hz "
    "(eine "
    "Lesart)"};
constexpr Sentence without_band{
    "mode {mode} at {frequency} Hz, delay {delay} ms, {residual} % left there (a reading)",
    "Modus {mode} bei {frequency} Hz, Verzögerung {delay} ms, dort {residual} % Rest (eine Lesart)"};
constexpr Sentence listed{"Vibration Guard: {figures}.", "Vibration Guard: {figures}."};
constexpr Sentence unusable{"No figures: these values give no Vibration Guard.",
                            "Keine Kennwerte: Diese Werte ergeben keinen Vibration Guard."};

}  // namespace axisc::editor::says

namespace axisc::editor {

std::string guard_text(design::KernelSpecification const& guard, design::CycleTime cycle_time,
                       Language language) {
  constexpr int shown_digits = 3;
  auto const kernel = design::design_kernel(guard, cycle_time);
  auto const band = design::robustness(kernel, guard, cycle_time);
  auto const short_number = [](double value) { return format_rounded(value, shown_digits); };
  std::vector<Argument> arguments{
      {"mode", std::to_string(guard.order)},
      {"frequency", exact_number(guard.frequency.value)},
      {"delay", short_number(kernel.group_delay_cycles * cycle_time.microseconds() / 1000)}};
  if (band) {
    arguments.push_back({"from", short_number(band->from.value)});
    arguments.push_back({"to", short_number(band->to.value)});
  } else {
    double const residual = 100 * design::residual_at_design(kernel, guard, cycle_time);
    arguments.push_back({"residual", short_number(residual)});
  }
  return say(band ? says::with_band : says::without_band, language, std::move(arguments));
}

std::string listed_guard_text(validator::EffectiveValues const& values, design::CycleTime cycle_time,
                              Language language) {
  auto const guard = validator::GuardView(values).specification(cycle_time);
  if (!guard || !validator::can_be_compiled(*guard, cycle_time)) return say(says::unusable, language);
  return say(says::listed, language, {{"figures", guard_text(*guard, cycle_time, language)}});
}

}  // namespace axisc::editor
