// A circle that was travelled once in one direction.
#pragma once

#include <cstddef>
#include <numbers>
#include <vector>

namespace axisc::circle {

/// From the first axis u to the second axis v (G03), or back (G02).
enum class Sense : int { counterclockwise = 1, clockwise = -1 };

[[nodiscard]] constexpr double sign_of(Sense sense) {
  return static_cast<double>(sense);
}

/// In radians.
inline constexpr double degree = std::numbers::pi / 180;

/// A position in µm, and the angle that it stands for.
struct Sample {
  double u = 0, v = 0;
  double weight = 0;  ///< rad
};

/// 360° of positions about the centre of their setpoints, or, without these, in the coordinates of the
/// recording.
struct Turn {
  Sense sense = Sense::counterclockwise;
  std::vector<Sample> samples;  ///< in the order of time; weights are 2π together
  double radius = 0;            ///< µm, of the setpoints; 0 without them
  double angular_speed = 0;     ///< rad/s; 0: not known
};

/// Weights of positions at these angles, rad, which rise or fall over at least a turn and are the turn's last
/// ones: half the angle between the neighbours, the first one cut so that they are 2π together.
void weigh(std::vector<Sample>& samples, std::vector<double> const& angles);

}  // namespace axisc::circle
