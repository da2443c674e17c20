// What the words of a program say about how fast its blocks are passed: weights of the lists' values, the
// slope, limits of the path. Blocks share one of these until a word changes it.
#pragma once

#include "analysis/motion/point.hpp"
#include "configuration/machine/path_dynamics.hpp"

#include <array>
#include <limits>
#include <optional>

namespace axisc::motion {

/// Percent of what a list sets. Caps (P-AXIS-00292, 00293, vb_max) are the planner's business.
struct RampWeights {
  double acceleration = 100;               ///< G130, G131; G230, G231 in G00. STEP: of both stages
  double build_up = 100, take_back = 100;  ///< ramp times: G132, G133; G233 in G00
};

struct AxisWeights {
  double velocity = 100;  ///< G127, G128 of vb_max; G129 of vb_eilgang in G00; 0 is 1 µm/s
  RampWeights up, down;
  double curve_ramp = 100;  ///< G134: of P-AXIS-00199
};

/// #VECTOR LIMIT, converted from what P-CHAN-00351 says of its units; infinite where it does not limit.
struct VectorLimit {
  static constexpr double none = std::numeric_limits<double>::infinity();
  double velocity = none;      ///< mm/s
  double acceleration = none;  ///< mm/s²; on circles only with P-CHAN-00350, of which the planner takes care
  double deceleration = none;
  double radial_acceleration = none;
};

struct BlockDynamics {
  machine::Slope slope = machine::Slope::step;  ///< #SLOPE; DEFAULT is P-CHAN-00071
  bool constant_ramp_times = false;             ///< P-CHAN-00349
  /// By axis in the order of the path: for feed blocks (G01 to G03), and for G00.
  std::array<AxisWeights, most_axes> feed{}, rapid{};
  bool limits_corners = true;  ///< G115: bit 2
  bool limits_curves = true;   ///< G115: bit 8, curve acceleration
  VectorLimit vector;
  std::optional<double> least_corner_velocity;  ///< #TRANSVELMIN, mm/s
};

}  // namespace axisc::motion
