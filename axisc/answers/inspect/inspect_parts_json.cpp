#include "axisc/answers/inspect/inspect_parts_json.hpp"

#include "axisc/asked/filter_symbols.hpp"
#include "axisc/files/image_file.hpp"
#include "design/kernel_analysis.hpp"
#include "design/kernel_kinds.hpp"

namespace axisc {

namespace {

using nlohmann::ordered_json;

ordered_json index_json(std::optional<std::size_t> index) {
  return index ? ordered_json(*index) : ordered_json(nullptr);
}

char const* type_name(design::KernelType type) {
  switch (type) {
    case design::KernelType::moving_average:
      return "moving average";
    case design::KernelType::gaussian:
      return "Gaussian";
    case design::KernelType::windowed_sinc:
      return "windowed sinc";
    case design::KernelType::time_delay:
      return "time delay";
    case design::KernelType::novib:
      return "NoVib";
  }
  return "";
}

char const* controller_name(machine::PositionController controller) {
  switch (controller) {
    case machine::PositionController::drive:
      return "drive";
    case machine::PositionController::cnc:
      return "cnc";
    case machine::PositionController::unknown:
      break;
  }
  return "unknown";
}

ordered_json stage_json(image::ImageStage const& stage, design::CycleTime cycle_time) {
  ordered_json json{{"index", stage.index},
                    {"mode", mode_word(stage.mode)},
                    {"weight", stage.weight},
                    {"weight_numerator", stage.weight_numerator},
                    {"weight_denominator", stage.weight_denominator}};
  json["filters"] = ordered_json::array();
  for (std::size_t i = 0; i < stage.filters.size(); ++i) {
    auto const& filter = stage.filters[i];
    bool const oscillator = stage.has_oscillator && i == 0;
    ordered_json entry;
    if (oscillator) {
      entry = {{"type", "oscillator"},
               {"frequency_hz", filter.specification.frequency.value},
               {"damping", filter.specification.quality}};
    } else {
      entry = {{"type", type_word(filter.specification.type)},
               {"prototype", prototype_word(filter.specification.prototype)},
               {"order", filter.specification.order},
               {"frequency_hz", filter.specification.frequency.value}};
      if (design::uses_quality(filter.specification.type)) entry["quality"] = filter.specification.quality;
    }
    entry["pole_radius"] = filter.design.pole_radius;
    entry["dc_gain"] = filter.design.dc_gain;
    entry["self_test_samples"] = filter.self_test_input.size();
    entry["sections"] = ordered_json::array();
    for (auto const& section : filter.design.sections) {
      entry["sections"].push_back(section_json(section, filter.design.blocks_constant, cycle_time));
    }
    json["filters"].push_back(std::move(entry));
  }
  return json;
}

}  // namespace

ordered_json slot_json(image::ImageSlot const& slot) {
  bool const hsc = slot.family == machine::KernelFamily::hsc;
  return {{"path", hsc ? "filter[" + std::to_string(slot.index) + "]" : "filter_fir"},
          {"family", hsc ? "HSC" : "FIR"},
          {"on_at_start", slot.on_at_start},
          {"kernel", index_json(slot.kernel)},
          {"channel", index_json(slot.group)}};
}

void add_readings(ordered_json& json, std::string_view reading, std::string_view cycle_time) {
  if (reading != word_of(design::FilterReading::documented)) json["reading"] = reading;
  if (cycle_time != word_of(design::CycleReading::documented)) json["computed_for"] = cycle_time;
}

ordered_json kernel_json(image::ImageKernel const& kernel, design::CycleTime cycle_time) {
  auto const& wanted = kernel.specification;
  auto const& kind = design::kind_of(wanted.type);
  ordered_json json{{"type", type_name(wanted.type)}, {"order", wanted.order}};
  if (kind.uses_frequency) json["frequency_hz"] = wanted.frequency.value;
  if (kind.uses_quality) json["quality"] = wanted.quality;
  json["share_percent"] = wanted.share_percent;
  add_readings(json, word_of(wanted.reading), word_of(wanted.cycle_time));
  json["half_width"] = kernel.design.half_width;
  json["delay_cycles"] = kernel.design.delay_cycles;
  json["group_delay_cycles"] = kernel.design.group_delay_cycles;
  json["group_delay_ms"] = kernel.design.group_delay_cycles * cycle_time.seconds() * 1e3;
  json["overshoot_percent"] = kernel.overshoot * 100;
  json["peak_gain"] = kernel.peak_gain;
  json["kernel_sum"] = kernel.design.kernel_sum;
  json["self_test_samples"] = kernel.self_test_input.size();
  json["zeros_hz"] = ordered_json::array();
  for (auto const zero : design::zero_frequencies(kernel.design, cycle_time)) {
    json["zeros_hz"].push_back(zero.value);
  }
  json["taps"] = kernel.design.taps;
  json["tail_sums"] = kernel.design.tail_sums;
  return json;
}

ordered_json group_json(image::ImageContents const& image, image::ImageGroup const& group) {
  ordered_json json{{"name", group.name}, {"axes", ordered_json::array()}, {"banks", ordered_json::array()}};
  for (auto const axis : group.members) json["axes"].push_back(axis_label(image, axis));
  for (auto const& bank : group.banks) {
    ordered_json entry{{"keywords", bank.hsc ? "HSC" : to_text(bank.parameters)},
                       {"fade_cycles", bank.fade_cycles},
                       {"kernels", ordered_json::array()}};
    for (auto const kernel : bank.kernels) entry["kernels"].push_back(index_json(kernel));
    json["banks"].push_back(std::move(entry));
  }
  json["off_fade_cycles"] = group.off_fade_cycles;
  return json;
}

ordered_json control_json(image::ImageContents const& image, image::ImageControl const& control) {
  ordered_json json{{"source", axis_label(image, control.source)},
                    {"limit", control.limit},
                    {"limit_factor", control.limit_factor},
                    {"position_control", controller_name(control.scaling.controller)},
                    {"time_base", control.scaling.time_base},
                    {"v_reso_num", control.scaling.v_reso_num},
                    {"v_reso_denom", control.scaling.v_reso_denom},
                    {"multi_gain_z", control.scaling.multi_gain_z},
                    {"multi_gain_n", control.scaling.multi_gain_n},
                    {"increments_per_velocity", control.increments_per_velocity}};
  json["stages"] = ordered_json::array();
  for (auto const& stage : control.stages) json["stages"].push_back(stage_json(stage, image.cycle_time));
  return json;
}

}  // namespace axisc
