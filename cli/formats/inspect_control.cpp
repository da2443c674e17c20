#include "cli/options/filter_symbols.hpp"
#include "cli/files/image_file.hpp"
#include "cli/formats/inspect_writer.hpp"
#include "diagnostics/format_number.hpp"

namespace axisc::cli {

std::string InspectWriter::control_text(std::size_t axis) const {
  auto const& control = image_.axes[axis].control;
  if (!control) return {};
  bool const linear = image_.axes[axis].type == 1;
  std::string const unit = linear ? "µm/s" : "0.001 °/s";
  std::string text =
      "\n  " +
      (control->source == axis
           ? say(Text::inspect_control,
                 {{"limit", rounded(control->limit / 1e3) + (linear ? " mm/s" : " °/s")}})
           : say(Text::inspect_control_of_master, {{"axis", axis_label(image_, control->source)}})) +
      "\n    ";
  switch (control->scaling.controller) {
    case machine::PositionController::drive:
      text += say(Text::inspect_control_drive,
                  {{"scale", format_exact(control->increments_per_velocity)}, {"unit", unit}});
      break;
    case machine::PositionController::cnc:
      text += say(Text::inspect_control_cnc,
                  {{"scale", format_exact(control->increments_per_velocity)}, {"unit", unit}});
      break;
    case machine::PositionController::unknown:
      text += say(Text::inspect_control_unknown);
      break;
  }
  text += "\n";
  for (auto const& stage : control->stages) text += stage_text(stage);
  return text;
}

std::string InspectWriter::stage_text(image::ImageStage const& stage) const {
  std::string text = "    " +
                     say(Text::inspect_stage, {{"index", std::to_string(stage.index)},
                                               {"mode", std::string(mode_word(stage.mode))},
                                               {"weight", format_exact(stage.weight)},
                                               {"numerator", format_exact(stage.weight_numerator)},
                                               {"denominator", format_exact(stage.weight_denominator)}}) +
                     "\n";
  for (std::size_t i = 0; i < stage.filters.size(); ++i) {
    auto const& wanted = stage.filters[i].specification;
    auto const frequency = format_exact(wanted.frequency.value);
    text += "      ";
    if (stage.has_oscillator && i == 0) {
      text += say(Text::inspect_oscillator,
                  {{"frequency", frequency}, {"damping", format_exact(wanted.quality)}});
    } else {
      text += std::string(type_word(wanted.type)) + ", " + std::string(prototype_word(wanted.prototype)) +
              ", " + say(Text::inspect_column_order) + " " + std::to_string(wanted.order) + ", " + frequency +
              " Hz";
      if (design::uses_quality(wanted.type)) {
        text += ", " + say(Text::inspect_column_quality) + " " + format_exact(wanted.quality);
      }
    }
    text += "\n";
    auto const& made = stage.filters[i].design;
    for (std::size_t j = 0; j < made.sections.size(); ++j) text += "    " + section(j, made);
  }
  return text;
}

}  // namespace axisc::cli
