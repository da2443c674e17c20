// `identify --emit plant`: a plant file of what was identified, what the lists say, and what the user knows.
#pragma once

#include "axisc/answers/identify/identified_axis.hpp"
#include "axisc/settings/plant_file.hpp"

#include <string>
#include <vector>

namespace axisc {

/// "KEY=VALUE". Failure for other texts, and for keys and values that a plant does not have.
[[nodiscard]] PlantValue read_plant_value(std::string const& text);

/// The mass that was identified is that of motor, load and structure together: one of motor and load has to
/// be known, the other one is the rest. Kv is that of the list where it is not known otherwise. Failure for a
/// mass that is not in kg, a guessed unit, known masses that disagree with the identified one, and while a
/// required key is missing: it lists what is there, and what is missing.
[[nodiscard]] std::string identified_plant(IdentifiedAxis const& found, std::vector<PlantValue> known);

}  // namespace axisc
