// Mass, friction and gravity of an axis from recordings of its force and position in ordinary motion.
//
// Windows of several lengths are fitted, and the length with the narrowest mass wins. What is given is of the
// elastic model (model_fit.hpp); the rigid one is there to disagree with it where resonances or the drive
// spoil both. With the half width w of the 95 % interval, an uncertainty is
//
//     √((1.5 w)² + (half of the spread over the lengths)² + (elastic - rigid)² + (3 %)²)
#pragma once

#include "analysis/tuning/rigid_model/motion_windows.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace axisc::tuning {

struct Estimate {
  double value = 0, uncertainty = 0;

  /// The uncertainty is at most this share of the value, which is positive.
  [[nodiscard]] bool is_within(double share) const { return value > 0 && uncertainty <= share * value; }
};

/// Why there is no mass.
enum class RigidDoubt : std::uint8_t {
  no_motion,
  too_short,        ///< less than shortest_motion, or not enough windows
  one_direction,    ///< friction and gravity cannot be told apart
  coarse,           ///< the noise of the position hides the acceleration
  no_acceleration,  ///< `accelerating` is too small
  unexplained,      ///< `explained` is too small
  scattered,        ///< the mass varies from block to block, or with the length of the windows
  elastic,          ///< rigid and elastic model do not agree
};

/// Units: m or rad, s, and the unit of the force.
struct RigidModel {
  std::optional<RigidDoubt> doubt;
  Estimate mass;                           ///< of motor and load
  Estimate coulomb;                        ///< c
  Estimate viscous;                        ///< b
  Estimate constant;                       ///< g
  double explained = 0, accelerating = 0;  ///< see ModelFit
  int dead_time = 0;                       ///< samples
  std::size_t length = 0, windows = 0;     ///< of the windows, in samples, and how many there are

  [[nodiscard]] bool has_mass() const { return !doubt; }
  [[nodiscard]] bool has_coulomb() const;
  [[nodiscard]] bool has_viscous() const;
};

/// All with a sample every T s. Cost: 50 ms for 10 s at 1 kHz.
[[nodiscard]] RigidModel rigid_model_of(std::span<MotionRecord const> records, double T);

}  // namespace axisc::tuning
