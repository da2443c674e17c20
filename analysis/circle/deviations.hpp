// The figures of a circular test after ISO 230-4:2005, as secondary sources give them.
//
// ρ = distance from a centre - R, outward positive.
//
//   G, of a direction   max - min of ρ about the least squares centre of that path
//   G(b)                the same over both paths, about their common centre
//   D                   radius of the common circle - R
//   F max, F min        ρ about the centre of the setpoint
//   hysteresis          largest difference of the two directions at one angle, of 3600, about the common
//                       centre
#pragma once

#include "analysis/circle/turn.hpp"

#include <optional>
#include <span>

namespace axisc::circle {

/// All in µm.
struct Deviations {
  std::optional<double> counterclockwise, clockwise;  ///< G
  std::optional<double> bidirectional, mean_radial;   ///< G(b), D: of both directions
  double radial_max = 0, radial_min = 0;              ///< F
  std::optional<double> hysteresis;                   ///< of both directions
};

/// Of one turn, or of two in different directions, about the centre to which they refer; `radius` is R.
[[nodiscard]] Deviations deviations_of(std::span<Turn const> turns, double radius);

}  // namespace axisc::circle
