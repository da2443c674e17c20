// The plant file of `axisc simulate --plant`.
#pragma once

#include "configuration/json_shape.hpp"
#include "motion/plant.hpp"

#include <string>

namespace axisc::cli {

/// What a plant file may say.
extern configuration::JsonShape const plant_file_shape;

/// The plant of one axis. Failure AX9009 for whatever is wrong with the file, AX9001 where it cannot be read.
[[nodiscard]] motion::PlantParameters read_plant(std::string const& path, std::string const& axis);

}  // namespace axisc::cli
