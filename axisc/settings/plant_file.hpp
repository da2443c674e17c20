// The plant file of `axisc simulate --plant`.
#pragma once

#include "analysis/motion/plant.hpp"
#include "configuration/json_shape.hpp"

#include <string>

namespace axisc {

/// The shape of a plant file.
extern configuration::JsonShape const plant_file_shape;

/// The plant of one axis. Failure AX9009 for any mistake in the file, AX9001 if it cannot be read.
[[nodiscard]] motion::PlantParameters read_plant(std::string const& path, std::string const& axis);

}  // namespace axisc
