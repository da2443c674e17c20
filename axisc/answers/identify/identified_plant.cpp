#include "axisc/answers/identify/identified_plant.hpp"

#include "axisc/asked/quantities.hpp"
#include "axisc/environment/failure.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/joined.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace axisc::says {

constexpr Sentence not_known{"--known {text}: say KEY=VALUE, such as motor_mass_kg=120",
                             "--known {text}: SCHLÜSSEL=WERT angeben, etwa motor_mass_kg=120"};
constexpr Sentence twice{"--known {key}: named twice", "--known {key}: zweimal angegeben"};
constexpr Sentence not_in_kilograms{
    "the mass of axis {axis} is in {unit}, and a plant file has kg: record the force along the axis in N",
    "die Masse der Achse {axis} ist in {unit}, eine Streckendatei hat kg: die Kraft entlang der Achse in N "
    "aufzeichnen"};
constexpr Sentence no_unit{
    "nothing names the unit of the position, so that the mass may be wrong by orders of magnitude; say it "
    "with --unit",
    "nichts nennt die Einheit der Position, sodass die Masse um Größenordnungen falsch sein kann; mit --unit "
    "angeben"};
constexpr Sentence too_heavy{
    "--known: {known} kg of {keys} leave nothing of the {mass} kg that were identified",
    "--known: {known} kg von {keys} lassen nichts von den {mass} kg, die identifiziert sind"};
constexpr Sentence other_mass{
    "--known: {keys} are {known} kg together, and {mass} ± {uncertainty} kg were identified; leave one out, "
    "and it is the rest",
    "--known: {keys} sind zusammen {known} kg, identifiziert sind {mass} ± {uncertainty} kg; eine davon "
    "weglassen, dann ist sie der Rest"};
constexpr Sentence missing{
    "a plant file of axis {axis} also needs {missing}: add --known KEY=VALUE for each, from data sheets; "
    "known are {known}, and motor and load together {mass} ± {uncertainty} kg",
    "einer Streckendatei der Achse {axis} fehlen {missing}: je --known SCHLÜSSEL=WERT angeben, aus "
    "Datenblättern; bekannt sind {known} und Motor und Last zusammen {mass} ± {uncertainty} kg"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr std::string_view motor_key = "motor_mass_kg", load_key = "load_mass_kg",
                           structure_key = "structure_mass_kg", kv_key = "kv_per_s";
constexpr int digits = 4;

std::optional<double> number_of(std::vector<PlantValue> const& values, std::string_view key) {
  auto const* const found = find_plant_value(values, key);
  return found == nullptr ? std::nullopt : parse_finite(found->value);
}

/// Adds the mass that is not known.
void add_rest(std::vector<PlantValue>& values, tuning::Estimate const& mass) {
  double sum = 0;
  std::vector<std::string> keys;
  for (auto const key : {motor_key, load_key, structure_key}) {
    auto const known = number_of(values, key);
    if (!known) continue;
    sum += *known;
    keys.emplace_back(key);
  }
  bool const knows_motor = number_of(values, motor_key).has_value();
  bool const knows_load = number_of(values, load_key).has_value();
  auto const refuse = [&](SentenceRef why) {
    return Failure({why,
                    {{"keys", joined(keys)},
                     {"known", format_rounded(sum, digits)},
                     {"mass", format_rounded(mass.value, digits)},
                     {"uncertainty", format_rounded(mass.uncertainty, 2)}}});
  };
  if (knows_motor && knows_load) {
    if (std::abs(sum - mass.value) > mass.uncertainty) throw refuse(says::other_mass);
  } else if (knows_motor || knows_load) {
    if (!(sum < mass.value)) throw refuse(says::too_heavy);
    values.push_back({.key = std::string(knows_motor ? load_key : motor_key),
                      .value = format_rounded(mass.value - sum, digits).written()});
  }
}

}  // namespace

PlantValue read_plant_value(std::string const& text) {
  auto const assigned = parse_assigned(text);
  if (!assigned) throw Failure({says::not_known, {{"text", text}}});
  PlantValue value{.key = assigned->name, .value = assigned->value};
  check_plant_value(value);
  return value;
}

std::string identified_plant(IdentifiedAxis const& found, std::vector<PlantValue> known) {
  auto const units = model_units(found.force, found.is_rotary, "F");
  if (units.mass != "kg") {
    throw Failure({says::not_in_kilograms, {{"axis", found.axis}, {"unit", units.mass}}});
  }
  if (found.is_unit_guessed) throw Failure({says::no_unit});
  for (auto one = known.begin(); one != known.end(); ++one) {
    bool const is_again =
        std::any_of(known.begin(), one, [&](PlantValue const& other) { return other.key == one->key; });
    if (is_again) throw Failure({says::twice, {{"key", one->key}}});
  }
  auto const& mass = found.model.mass;
  if (found.kv && !number_of(known, kv_key)) {
    known.push_back({.key = std::string(kv_key), .value = exact_number(*found.kv).written()});
  }
  add_rest(known, mass);
  auto const missing = missing_plant_keys(known);
  auto const kilograms = format_rounded(mass.value, digits);
  auto const uncertainty = format_rounded(mass.uncertainty, 2);
  if (!missing.empty()) {
    std::vector<std::string> words{"name=" + found.axis};
    for (auto const& one : known) words.push_back(one.key + "=" + one.value);
    throw Failure({says::missing,
                   {{"axis", found.axis},
                    {"missing", joined(missing)},
                    {"known", joined(words)},
                    {"mass", kilograms},
                    {"uncertainty", uncertainty}}});
  }
  return plant_text(found.axis,
                    "identified: " + kilograms.written() + " +- " + uncertainty.written() + " kg in all",
                    known);
}

}  // namespace axisc
