// Turns that a measuring instrument recorded by itself, such as a telescoping ball bar: deviations from the
// radius by angle, without times.
#pragma once

#include "analysis/circle/recorded_turns.hpp"

#include <variant>
#include <vector>

namespace axisc::circle {

/// Of each direction the last 360°: angles rise counterclockwise. `angles_deg` and `deviations` in µm belong
/// together; `radius` in µm. Radius of the turns is `radius`, their angular speed not known.
[[nodiscard]] std::variant<std::vector<Turn>, BadTurn> external_turns(std::vector<double> const& angles_deg,
                                                                      std::vector<double> const& deviations,
                                                                      double radius);

}  // namespace axisc::circle
