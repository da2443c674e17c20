#include "editor/meaning/guard_figures.hpp"

#include "analysis/motion/contour/contour_predictions.hpp"
#include "analysis/motion/contour/ramp_answer.hpp"
#include "design/kernels/vibration_guard.hpp"
#include "diagnostics/format_number.hpp"
#include "editor/reading/requests.hpp"
#include "validator/views/guard_view.hpp"

#include <array>
#include <numbers>
#include <optional>
#include <vector>

namespace axisc::editor::says {

constexpr Sentence with_band{
    "mode {mode} at {frequency} Hz, delay {delay} ms, at most 5 % left from {from} to {to} Hz (a reading)",
    "Modus {mode} bei {frequency} Hz, Verzögerung {delay} ms, höchstens 5 % Rest von {from} bis {to} Hz "
    "(eine Lesart)"};
constexpr Sentence without_band{
    "mode {mode} at {frequency} Hz, delay {delay} ms, {residual} % left there (a reading)",
    "Modus {mode} bei {frequency} Hz, Verzögerung {delay} ms, dort {residual} % Rest (eine Lesart)"};
constexpr Sentence at_corner{
    "{figures}, axis error {error} µm at a corner of 90° at {feed} mm/min (vb_max)",
    "{figures}, Achsfehler {error} µm an einer Ecke von 90° bei {feed} mm/min (vb_max)"};
constexpr Sentence listed{"Vibration Guard: {figures}.", "Vibration Guard: {figures}."};
constexpr Sentence unusable{"No figures: these values give no Vibration Guard.",
                            "Keine Kennwerte: Diese Werte ergeben keinen Vibration Guard."};

}  // namespace axisc::editor::says

namespace axisc::editor {

namespace {

/// Between two axes with the kernel, in µm; none where its setpoint does not arrive.
std::optional<double> corner_error(design::KernelDesign const& kernel, double um_per_s,
                                   design::CycleTime cycle_time) {
  auto const answer = motion::chain_answer(motion::ramp_answer(kernel.taps));
  if (!answer) return std::nullopt;
  std::array const both = {*answer, *answer};
  double const velocity = um_per_s * cycle_time.seconds() * motion::units_per_um;
  auto const corner = motion::predict_corner(both, velocity, std::numbers::pi / 2);
  return corner.largest_axis_error() / motion::units_per_um;
}

}  // namespace

std::string guard_text(design::KernelSpecification const& guard, validator::LoadedAxis const& axis,
                       design::CycleTime cycle_time, Language language) {
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
  auto figures = say(band ? says::with_band : says::without_band, language, std::move(arguments));
  auto const& limit = axis.merged.values.at("getriebe[].dynamik.vb_max");
  bool const is_straight = axis.type == machine::AxisType::translatory;
  if (!is_straight || limit.unusable || !(limit.value.number > 0)) return figures;
  auto const error = corner_error(kernel, limit.value.number, cycle_time);
  if (!error) return figures;
  double const feed = limit.value.number * design::mm_per_min_of_um_per_s;
  return say(says::at_corner, language,
             {{"figures", figures}, {"error", short_number(*error)}, {"feed", format_rounded(feed, 6)}});
}

std::string listed_guard_text(validator::LoadedAxis const& axis, design::CycleTime cycle_time,
                              Language language) {
  auto const guard = validator::GuardView(axis.merged.values).specification(cycle_time);
  if (!guard || !validator::can_be_compiled(*guard, cycle_time)) return say(says::unusable, language);
  return say(says::listed, language, {{"figures", guard_text(*guard, axis, cycle_time, language)}});
}

}  // namespace axisc::editor
