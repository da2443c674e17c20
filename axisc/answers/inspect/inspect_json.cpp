#include "axisc/answers/inspect/inspect_formats.hpp"
#include "axisc/answers/inspect/inspect_parts_json.hpp"
#include "axisc/answers/json_text.hpp"
#include "axisc/asked/filter_symbols.hpp"
#include "axisc/files/image_file.hpp"
#include "axisc/files/key_file.hpp"
#include "design/filter_design.hpp"

#include <cmath>
#include <numbers>

namespace axisc {

namespace {

using nlohmann::ordered_json;

ordered_json pole_json(std::complex<double> pole, design::CycleTime cycle_time) {
  return {{"real", pole.real()},
          {"imaginary", pole.imag()},
          {"radius", std::abs(pole)},
          {"frequency_hz", std::abs(std::arg(pole)) / (2 * std::numbers::pi * cycle_time.seconds())}};
}

}  // namespace

ordered_json section_json(design::IncrementSection const& section, bool blocks_constant,
                          design::CycleTime cycle_time) {
  auto const direct = design::direct_form(section, blocks_constant);
  auto const [first, second] = design::poles(section);
  return {{"b0", direct.b0}, {"b1", direct.b1},
          {"b2", direct.b2}, {"a1", direct.a1},
          {"a2", direct.a2}, {"p", section.p},
          {"q", section.q},  {"k", section.k},
          {"b", section.b},  {"poles", {pole_json(first, cycle_time), pole_json(second, cycle_time)}}};
}

namespace {

char const* realisation_word(design::Realisation realisation) {
  switch (realisation) {
    case design::Realisation::pass_through:
      return "pass-through";
    case design::Realisation::sections:
      return "sections";
    case design::Realisation::delay:
      return "delay";
  }
  return "";
}

ordered_json value_json(image::ImageValue const& value) {
  return {{"name", value.name}, {"value", value.value}, {"file", value.list}, {"line", value.line}};
}

ordered_json filter_json(image::ImageAxis const& axis, image::ImageFilter const& filter, bool interface,
                         design::CycleTime cycle_time) {
  auto const& wanted = filter.specification;
  auto const& made = filter.design;
  ordered_json json{
      {"path", filter_path(filter, interface)}, {"index", filter.index}, {"type", type_word(wanted.type)}};
  if (design::uses_prototype(wanted.type)) json["prototype"] = prototype_word(wanted.prototype);
  if (!design::computes_order(wanted.type)) json["order"] = wanted.order;
  if (design::uses_frequency(wanted.type)) json["frequency_hz"] = wanted.frequency.value;
  if (design::uses_quality(wanted.type)) json["quality"] = wanted.quality;
  if (design::uses_time_constant(wanted.type)) json["time_constant_us"] = wanted.time_constant.value;
  json["share_percent"] = wanted.share_percent;
  add_readings(json, word_of(wanted.reading), word_of(wanted.cycle_time));
  json["realisation"] = realisation_word(made.realisation);
  if (made.realisation == design::Realisation::delay) json["pure_delay_cycles"] = made.delay_cycles;
  json["group_delay_cycles"] = made.group_delay_cycles;
  json["group_delay_ms"] = made.group_delay_cycles * cycle_time.seconds() * 1e3;
  json["dc_gain"] = made.dc_gain;
  json["overshoot_percent"] = filter.overshoot * 100;
  json["peak_gain"] = filter.peak_gain;
  json["peak_gain_is_reached"] = image::reaches_peak_gain(filter);
  json["pole_radius"] = made.pole_radius;
  json["kernel_sum"] = filter.kernel_sum;
  json["self_test_samples"] = filter.self_test_input.size();
  json["sections"] = ordered_json::array();
  for (auto const& section : made.sections) {
    json["sections"].push_back(section_json(section, made.blocks_constant, cycle_time));
  }
  json["settings"] = ordered_json::array();
  for (auto const& value : settings_of(axis, filter, interface)) {
    json["settings"].push_back(value_json(value));
  }
  return json;
}

char const* axis_type_word(std::uint32_t type) {
  switch (type) {
    case 1:
      return "T";
    case 2:
      return "R";
    case 4:
      return "S";
    default:
      return "?";
  }
}

ordered_json optional_json(std::optional<double> value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json chain_json(image::ImageContents const& image, std::size_t index,
                        image::ChainFigures const& chain) {
  ordered_json json;
  std::optional<double> settling;
  if (chain.settling_cycles) {
    settling = static_cast<double>(*chain.settling_cycles) * image.cycle_time.seconds() * 1e3;
  }
  json["settling_ms"] = optional_json(settling);
  json["overshoot_percent"] = chain.overshoot * 100;
  auto const corner = image::corner_frequency(image, index);
  json["corner_frequency_hz"] = corner ? ordered_json(corner->value) : ordered_json(nullptr);
  json["magnitudes"] = ordered_json::array();
  for (auto const frequency : image::characteristic_frequencies(image, index)) {
    json["magnitudes"].push_back(
        {{"frequency_hz", frequency.value},
         {"magnitude_db", optional_json(image::decibels(image::chain_magnitude(image, index, frequency)))}});
  }
  return json;
}

ordered_json axis_json(image::ImageContents const& image, std::size_t index,
                       image::ChainFigures const& chain) {
  auto const& axis = image.axes[index];
  ordered_json json{{"name", axis_label(image, index)},
                    {"number", axis.number},
                    {"type", axis_type_word(axis.type)},
                    {"position_unit", axis.type == 1 ? "0.1 um" : "1e-4 deg"},
                    {"position_window", axis.position_window},
                    {"velocity_limit", axis.velocity_limit},
                    {"acceleration_limit", axis.acceleration_limit},
                    {"delay_cycles", axis.delay_cycles},
                    {"delay_ms", axis.delay_cycles * image.cycle_time.seconds() * 1e3},
                    {"peak_gain", axis.peak_gain},
                    {"peak_gain_is_reached", image::reaches_peak_gain(image, index)},
                    {"chain", chain_json(image, index, chain)}};
  json["filters"] = ordered_json::array();
  for (auto const& filter : axis.filters) {
    json["filters"].push_back(filter_json(axis, filter, false, image.cycle_time));
  }
  json["interface_filters"] = ordered_json::array();
  for (auto const& filter : axis.interface_filters) {
    json["interface_filters"].push_back(filter_json(axis, filter, true, image.cycle_time));
  }
  if (axis.slot) json["linear_phase_filter"] = slot_json(*axis.slot);
  if (axis.control) json["position_control"] = control_json(image, *axis.control);
  json["values"] = ordered_json::array();
  for (auto const& value : axis.values) json["values"].push_back(value_json(value));
  return json;
}

}  // namespace

std::string inspect_json(Shown const& shown) {
  auto const& image = shown.image;
  ordered_json json{{"version", 1},
                    {"file", shown.file},
                    {"format", {{"major", image.format_major}, {"minor", image.format_minor}}},
                    {"size", image.size},
                    {"compiler_version", image.compiler_version},
                    {"image_version", image.image_version},
                    {"cycle_time_us", image.cycle_time.microseconds()},
                    {"source_digest", hexadecimal(image.source_digest)}};
  json["signature"] = nullptr;
  if (shown.signer) {
    json["signature"] = {
        {"algorithm", "Ed25519"}, {"key", key_name(*shown.signer)}, {"checked", shown.signature_checked}};
  }
  if (shown.memory) {
    json["memory"] = {{"bytes", *shown.memory}, {"alignment", AXISRT_ALIGNMENT}};
  }
  json["lists"] = ordered_json::array();
  for (auto const& list : image.lists) {
    json["lists"].push_back({{"name", list.name}, {"sha256", hexadecimal(list.sha256)}});
  }
  json["axes"] = ordered_json::array();
  for (std::size_t i = 0; i < shown.axes.size(); ++i) {
    json["axes"].push_back(axis_json(image, shown.axes[i], shown.figures[i]));
  }
  json["kernels"] = ordered_json::array();
  for (auto const& kernel : image.kernels) json["kernels"].push_back(kernel_json(kernel, image.cycle_time));
  json["channels"] = ordered_json::array();
  for (auto const& group : image.groups) json["channels"].push_back(group_json(image, group));
  return json_document(json);
}

}  // namespace axisc
