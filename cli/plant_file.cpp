#include "cli/plant_file.hpp"

#include "cli/codes.hpp"
#include "cli/disk_files.hpp"
#include "cli/failure.hpp"

#include <cmath>
#include <set>

#include <nlohmann/json.hpp>

namespace axisc::cli {

namespace {

using motion::PlantParameters;
using nlohmann::json;

/// A quantity of the file: its unit stands in its name.
struct Quantity {
  std::string_view key;
  double PlantParameters::*field;
  double unit;  ///< in SI units
  bool required;
  bool positive;  ///< else 0 is allowed
  double largest = 1e12;
};

constexpr Quantity quantities[] = {
    {"motor_mass_kg", &PlantParameters::motor_mass, 1, true, true},
    {"load_mass_kg", &PlantParameters::load_mass, 1, true, true},
    {"stiffness_n_per_um", &PlantParameters::stiffness, 1e6, true, true},
    {"damping_n_s_per_mm", &PlantParameters::damping, 1e3, true, false},
    {"tooth_pitch_mm", &PlantParameters::tooth_pitch, 1e-3, false, false},
    {"transmission_error_um", &PlantParameters::transmission_error, 1e-6, false, false},
    {"structure_mass_kg", &PlantParameters::structure_mass, 1, false, false},
    {"structure_frequency_hz", &PlantParameters::structure_frequency, 1, false, false},
    {"structure_damping_ratio", &PlantParameters::structure_damping, 1, false, false, 1},
    {"dead_time_us", &PlantParameters::dead_time, 1e-6, false, false, 1e6},
    {"velocity_bandwidth_hz", &PlantParameters::velocity_bandwidth, 1, true, true, 2000},
    {"velocity_reset_time_ms", &PlantParameters::velocity_reset_time, 1e-3, false, false},
    {"kv_per_s", &PlantParameters::kv, 1, true, true, 1e4},
    {"feedforward_percent", &PlantParameters::feedforward, 0.01, false, false, 100}};

[[noreturn]] void fail(std::string const& path, std::string const& place, Text reason,
                       std::vector<Argument> arguments) {
  // The sentence is English inside another sentence only for what the JSON parser says.
  arguments.push_back({"place", place.empty() ? path : path + ": " + place});
  throw Failure({.text = reason, .arguments = std::move(arguments)}, plant_file);
}

std::string range_text(Quantity const& quantity) {
  std::string text = quantity.positive ? "> 0" : "≥ 0";
  if (quantity.largest < 1e12) text += ", ≤ " + json(quantity.largest).dump();
  return text;
}

PlantParameters parameters_of(json const& axis, std::string const& path, std::string const& name) {
  PlantParameters parameters;
  std::set<std::string, std::less<>> known = {"name", "position_feedback", "comment"};
  for (auto const& quantity : quantities) {
    known.emplace(quantity.key);
    auto const found = axis.find(quantity.key);
    if (found == axis.end()) {
      if (quantity.required) fail(path, name, Text::ax9009_missing, {{"key", std::string(quantity.key)}});
      continue;
    }
    double const value = found->is_number() ? found->get<double>() : -1;
    bool const in_range = (quantity.positive ? value > 0 : value >= 0) && value <= quantity.largest;
    if (!in_range) {
      fail(path, name, Text::ax9009_range,
           {{"key", std::string(quantity.key)}, {"range", range_text(quantity)}});
    }
    parameters.*quantity.field = value * quantity.unit;
  }
  for (auto const& [key, value] : axis.items()) {
    if (!known.contains(key)) fail(path, name, Text::ax9009_unknown, {{"key", key}});
  }
  auto const feedback = axis.value("position_feedback", json("direct"));
  if (feedback != "direct" && feedback != "motor") {
    fail(path, name, Text::ax9009_range, {{"key", "position_feedback"}, {"range", R"("direct", "motor")"}});
  }
  parameters.feedback =
      feedback == "motor" ? motion::PositionFeedback::motor : motion::PositionFeedback::direct;
  if (parameters.structure_mass > 0 && !(parameters.structure_frequency > 0)) {
    fail(path, name, Text::ax9009_missing, {{"key", "structure_frequency_hz"}});
  }
  return parameters;
}

}  // namespace

motion::PlantParameters read_plant(std::string const& path, std::string const& axis) {
  auto const text = read_whole(path);
  json document;
  try {
    document = json::parse(text, nullptr, true, true);
  } catch (json::parse_error const& error) {
    fail(path, {}, Text::ax9009_json, {{"reason", error.what()}});
  }
  if (!document.is_object()) fail(path, {}, Text::ax9009_json, {{"reason", document.type_name()}});
  auto const plants = document.find("plants");
  if (plants == document.end() || !plants->is_array()) {
    fail(path, {}, Text::ax9009_missing, {{"key", "plants"}});
  }
  for (auto const& entry : *plants) {
    if (entry.is_object() && entry.value("name", json()) == axis) return parameters_of(entry, path, axis);
  }
  fail(path, {}, Text::ax9009_axis, {{"axis", axis}});
}

}  // namespace axisc::cli
