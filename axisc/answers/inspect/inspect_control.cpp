#include "axisc/answers/inspect/inspect_writer.hpp"
#include "axisc/answers/sentences.hpp"
#include "axisc/asked/filter_symbols.hpp"
#include "axisc/files/image_file.hpp"
#include "diagnostics/format_number.hpp"

namespace axisc::says {

constexpr Sentence control{"Improved Position Control: additive velocity within ±{limit}",
                           "Optimierte Lageregelung: additive Geschwindigkeit innerhalb ±{limit}"};
constexpr Sentence of_master{"Improved Position Control: additive velocity of the gantry master {axis}",
                             "Optimierte Lageregelung: additive Geschwindigkeit des Gantry-Masters {axis}"};
constexpr Sentence drive{"position control in the drive: {scale} increments per {unit}",
                         "Lageregelung im Antrieb: {scale} Inkremente je {unit}"};
constexpr Sentence cnc{"position control in the CNC: {scale} increments per {unit}",
                       "Lageregelung in der CNC: {scale} Inkremente je {unit}"};
constexpr Sentence unknown{"it is not known where the position is controlled: no increments",
                           "wo die Lage geregelt wird, ist nicht bekannt: keine Inkremente"};
constexpr Sentence stage{
    "stage[{index}] {mode}, weight {weight} ({numerator}/{denominator}), subtracted",
    "stage[{index}] {mode}, Gewicht {weight} ({numerator}/{denominator}), wird abgezogen"};
constexpr Sentence oscillator{"oscillator, {frequency} Hz, damping {damping}",
                              "Schwinger, {frequency} Hz, Dämpfung {damping}"};

}  // namespace axisc::says

namespace axisc {

std::string InspectWriter::control_text(std::size_t axis) const {
  auto const& control = image_.axes[axis].control;
  if (!control) return {};
  bool const linear = image_.axes[axis].type == 1;
  std::string const unit = linear ? "µm/s" : exact(0.001) + " °/s";
  std::string text =
      "\n  " +
      (control->source == axis
           ? say(says::control, {{"limit", rounded(control->limit / 1e3) + (linear ? " mm/s" : " °/s")}})
           : say(says::of_master, {{"axis", axis_label(image_, control->source)}})) +
      "\n    ";
  switch (control->scaling.controller) {
    case machine::PositionController::drive:
      text += say(says::drive, {{"scale", exact(control->increments_per_velocity)}, {"unit", unit}});
      break;
    case machine::PositionController::cnc:
      text += say(says::cnc, {{"scale", exact(control->increments_per_velocity)}, {"unit", unit}});
      break;
    case machine::PositionController::unknown:
      text += say(says::unknown);
      break;
  }
  text += "\n";
  for (auto const& stage : control->stages) text += stage_text(stage);
  return text;
}

std::string InspectWriter::stage_text(image::ImageStage const& stage) const {
  std::string text = "    " +
                     say(says::stage, {{"index", std::to_string(stage.index)},
                                       {"mode", std::string(mode_word(stage.mode))},
                                       {"weight", exact(stage.weight)},
                                       {"numerator", exact(stage.weight_numerator)},
                                       {"denominator", exact(stage.weight_denominator)}}) +
                     "\n";
  for (std::size_t i = 0; i < stage.filters.size(); ++i) {
    auto const& wanted = stage.filters[i].specification;
    auto const frequency = exact(wanted.frequency.value);
    text += "      ";
    if (stage.has_oscillator && i == 0) {
      text += say(says::oscillator, {{"frequency", frequency}, {"damping", exact(wanted.quality)}});
    } else {
      text += std::string(type_word(wanted.type)) + ", " + std::string(prototype_word(wanted.prototype)) +
              ", " + say(says::inspect_column_order) + " " + std::to_string(wanted.order) + ", " + frequency +
              " Hz";
      if (design::uses_quality(wanted.type)) {
        text += ", " + say(says::inspect_column_quality) + " " + exact(wanted.quality);
      }
    }
    text += "\n";
    auto const& made = stage.filters[i].design;
    for (std::size_t j = 0; j < made.sections.size(); ++j) text += "    " + section(j, made);
  }
  return text;
}

}  // namespace axisc
