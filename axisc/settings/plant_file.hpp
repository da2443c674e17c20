// The plant file of `axisc simulate --plant`.
#pragma once

#include "analysis/motion/plant.hpp"
#include "configuration/json_shape.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace axisc {

/// The shape of a plant file.
extern configuration::JsonShape const plant_file_shape;

/// The plant of one axis. Failure AX9009 for any mistake in the file, AX9001 if it cannot be read.
[[nodiscard]] motion::PlantParameters read_plant(std::string const& path, std::string const& axis);

/// A key of a plant and its value, a number or a word.
struct PlantValue {
  std::string key, value;
};

/// Null where it is not among them.
[[nodiscard]] PlantValue const* find_plant_value(std::vector<PlantValue> const& values, std::string_view key);

/// Failure for a key that a plant does not have, and for a value that the key cannot have.
void check_plant_value(PlantValue const& value);

/// Keys that a plant must have, and these do not; "name" is not counted.
[[nodiscard]] std::vector<std::string> missing_plant_keys(std::vector<PlantValue> const& values);

/// A plant file for one axis, its keys in the order of docs/plant-file.md.
[[nodiscard]] std::string plant_text(std::string const& axis, std::string const& comment,
                                     std::vector<PlantValue> const& values);

}  // namespace axisc
