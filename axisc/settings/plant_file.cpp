#include "axisc/settings/plant_file.hpp"

#include "axisc/asked/quantities.hpp"
#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/settings/located_file.hpp"
#include "configuration/json_reading.hpp"
#include "configuration/sentences.hpp"
#include "diagnostics/joined.hpp"
#include "diagnostics/writers/json_stream.hpp"
#include "presentation/value.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace axisc::says {

constexpr Sentence plant_json{"the plant file is not valid JSON here",
                              "die Streckendatei ist hier kein gültiges JSON"};
constexpr Sentence not_a_key{"\"{key}\" is not a key of a plant file; there are {known}",
                             "\"{key}\" ist kein Schlüssel einer Streckendatei; es gibt {known}"};
constexpr Sentence not_a_number{"{key}={value}: a number {range} is needed",
                                "{key}={value}: nötig ist eine Zahl {range}"};
constexpr Sentence not_a_word{"{key}={value}: one of {words} is needed",
                              "{key}={value}: nötig ist eines von {words}"};
constexpr Sentence above{"above {low}, up to {high}", "über {low}, bis {high}"};
constexpr Sentence from{"from {low} to {high}", "von {low} bis {high}"};
constexpr Sentence axis{"there is no plant for axis {axis}", "für Achse {axis} gibt es keine Strecke"};

}  // namespace axisc::says

namespace axisc {

namespace {

using configuration::into;
using configuration::JsonKey;
using configuration::JsonReading;
using configuration::JsonShape;
using configuration::JsonValue;
using motion::PlantParameters;
using Kind = configuration::JsonShapeKind;
using enum configuration::JsonPresence;

constexpr double one = 1, kilo = 1e3, mega = 1e6, milli = 1e-3, micro = 1e-6, percent = 1e-2;

/// A quantity in the unit that its name ends with; `in` is that unit in SI units.
template <double PlantParameters::*member, double const& in = one>
void quantity(JsonReading const& /*reading*/, JsonShape const& /*shape*/, JsonValue const& value,
              void* target) {
  static_cast<PlantParameters*>(target)->*member = value.number * in;
}

constexpr JsonShape from_zero(double highest = 1e12) {
  return {.kind = Kind::number, .lowest = 0, .highest = highest};
}
constexpr JsonShape above_zero(double highest = 1e12) {
  return {.kind = Kind::number, .lowest = 0, .highest = highest, .above_lowest = true};
}

constexpr JsonShape positive = above_zero();
constexpr JsonShape not_negative = from_zero();
constexpr JsonShape damping_ratio = from_zero(1);
constexpr JsonShape dead_time = from_zero(1e6);
constexpr JsonShape bandwidth = above_zero(2000);
constexpr JsonShape gain = above_zero(1e4);
constexpr JsonShape feedforward = from_zero(100);
constexpr std::array<std::string_view, 2> feedbacks = {"direct", "motor"};
constexpr JsonShape feedback{.words = feedbacks};

constexpr std::array plant_keys = {
    JsonKey{"name", &configuration::json_text, required, "Name of the axis."},
    JsonKey{"comment", &configuration::any_json, optional, "Anything."},
    JsonKey{"motor_mass_kg", &positive, required, "Mass of motor, gear and pinion at the pinion.",
            quantity<&PlantParameters::motor_mass>},
    JsonKey{"load_mass_kg", &positive, required, "Mass of the carriage.",
            quantity<&PlantParameters::load_mass>},
    JsonKey{"stiffness_n_per_um", &positive, required, "Stiffness of the drive train.",
            quantity<&PlantParameters::stiffness, mega>},
    JsonKey{"damping_n_s_per_mm", &not_negative, required, "Damping of the drive train.",
            quantity<&PlantParameters::damping, kilo>},
    JsonKey{"tooth_pitch_mm", &not_negative, optional, "Distance travelled per tooth; left out: no teeth.",
            quantity<&PlantParameters::tooth_pitch, milli>},
    JsonKey{"transmission_error_um", &not_negative, optional,
            "Amplitude of the transmission error of the teeth.",
            quantity<&PlantParameters::transmission_error, micro>},
    JsonKey{"structure_mass_kg", &not_negative, optional,
            "Mass of the column or cross-beam that swings on the carriage; left out: none.",
            quantity<&PlantParameters::structure_mass>},
    JsonKey{"structure_frequency_hz", &not_negative, optional, "Natural frequency of the structure.",
            quantity<&PlantParameters::structure_frequency>},
    JsonKey{"structure_damping_ratio", &damping_ratio, optional, "Damping ratio of the structure.",
            quantity<&PlantParameters::structure_damping>},
    JsonKey{"dead_time_us", &dead_time, optional, "From command to drive.",
            quantity<&PlantParameters::dead_time, micro>},
    JsonKey{"velocity_bandwidth_hz", &bandwidth, required, "Bandwidth of the velocity controller.",
            quantity<&PlantParameters::velocity_bandwidth>},
    JsonKey{"velocity_reset_time_ms", &not_negative, optional,
            "Reset time of the velocity controller; left out: no integral part.",
            quantity<&PlantParameters::velocity_reset_time, milli>},
    JsonKey{"kv_per_s", &gain, required, "Gain of the position controller.", quantity<&PlantParameters::kv>},
    JsonKey{"feedforward_percent", &feedforward, optional, "Velocity feedforward.",
            quantity<&PlantParameters::feedforward, percent>},
    JsonKey{"position_feedback", &feedback, optional,
            "Which position is controlled; direct unless it says motor.", into<&PlantParameters::feedback>}};
constexpr JsonShape plant_shape{.kind = Kind::object, .title = "Plant of one axis", .keys = plant_keys};
constexpr JsonShape plants_shape{.kind = Kind::list, .items = &plant_shape};
constexpr std::array plant_file_keys = {
    JsonKey{"plants", &plants_shape, required, "One plant for each axis."}};

/// Those that are neither the name nor a comment.
bool is_figure(JsonKey const& key) {
  return key.store != nullptr;
}

std::string known_keys() {
  std::string known;
  for (auto const& key : plant_keys) {
    if (is_figure(key)) known.append(known.empty() ? "" : ", ").append(key.name);
  }
  return known;
}

bool is_in_range(double number, JsonShape const& shape) {
  bool const is_low = shape.above_lowest ? number > shape.lowest : number >= shape.lowest;
  return is_low && number <= shape.highest;
}

}  // namespace

constexpr JsonShape plant_file_shape{
    .kind = Kind::object, .title = "Plant file of axisc", .keys = plant_file_keys};

motion::PlantParameters read_plant(std::string const& path, std::string const& axis) {
  LocatedFile const file(path, plant_file_shape, says::plant_json, plant_file);
  auto const& plants = *file.find(file.root(), "plants");
  for (auto const item : plants.items) {
    auto const& plant = file[item];
    if (file.find(plant, "name")->string != axis) continue;
    PlantParameters parameters;
    file.fill(plant_shape, plant, &parameters);
    if (parameters.structure_mass > 0 && !(parameters.structure_frequency > 0)) {
      file.refuse(plant.span, axisc::configuration::says::json_missing_key,
                  {{"key", "structure_frequency_hz"}});
    }
    return parameters;
  }
  file.refuse(plants.span, says::axis, {{"axis", axis}});
}

PlantValue const* find_plant_value(std::vector<PlantValue> const& values, std::string_view key) {
  auto const found =
      std::find_if(values.begin(), values.end(), [key](PlantValue const& each) { return each.key == key; });
  return found == values.end() ? nullptr : &*found;
}

void check_plant_value(PlantValue const& value) {
  auto const* const key = std::find_if(plant_keys.begin(), plant_keys.end(), [&](JsonKey const& each) {
    return is_figure(each) && each.name == value.key;
  });
  if (key == plant_keys.end()) {
    throw Failure({says::not_a_key, {{"key", value.key}, {"known", known_keys()}}});
  }
  auto const& shape = *key->shape;
  if (!shape.words.empty()) {
    if (std::find(shape.words.begin(), shape.words.end(), value.value) != shape.words.end()) return;
    throw Failure(
        {says::not_a_word, {{"key", value.key}, {"value", value.value}, {"words", joined(shape.words)}}});
  }
  auto const number = parse_finite(value.value);
  if (number && is_in_range(*number, shape)) return;
  auto const range = presentation::Words(
      shape.above_lowest ? SentenceRef(says::above) : SentenceRef(says::from),
      {{"low", presentation::exact(shape.lowest)}, {"high", presentation::exact(shape.highest)}});
  throw Failure({says::not_a_number,
                 {{"key", value.key}, {"value", value.value}, {"range", presentation::wording_of(range)}}});
}

std::vector<std::string> missing_plant_keys(std::vector<PlantValue> const& values) {
  std::vector<std::string> missing;
  for (auto const& key : plant_keys) {
    bool const is_missing =
        is_figure(key) && key.presence == required && find_plant_value(values, key.name) == nullptr;
    if (is_missing) missing.emplace_back(key.name);
  }
  return missing;
}

std::string plant_text(std::string const& axis, std::string const& comment,
                       std::vector<PlantValue> const& values) {
  std::string text;
  JsonStream json(text, 0);
  json.begin_object();
  json.key("plants");
  json.begin_array();
  json.begin_object();
  json.member("name", axis);
  json.member("comment", comment);
  for (auto const& key : plant_keys) {
    auto const* const value = is_figure(key) ? find_plant_value(values, key.name) : nullptr;
    if (value == nullptr) continue;
    json.key(key.name);
    if (key.shape->words.empty()) {
      json.raw(presentation::json_number(parse_finite(value->value).value_or(0)));
    } else {
      json.string(value->value);
    }
  }
  json.end_object();
  json.end_array();
  json.end_object();
  return text + "\n";
}

}  // namespace axisc
