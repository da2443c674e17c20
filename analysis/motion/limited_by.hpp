// What keeps a block from being passed faster.
#pragma once

#include <cstdint>
#include <limits>

namespace axisc::motion {

/// A velocity, acceleration or jerk where nothing limits it.
inline constexpr double unlimited = std::numeric_limits<double>::infinity();

enum class LimitedBy : std::uint8_t {
  feed,          ///< F, or #VECTOR LIMIT
  axis,          ///< velocity of an axis; also its acceleration, where the block ends before more is reached
  curve,         ///< acceleration on an arc
  curve_jerk,    ///< P-AXIS-00199
  corner,        ///< the corner at its end
  tangent_jerk,  ///< an arc begins or ends at its end (P-CHAN-00009)
  braking,       ///< a slower place further on
  look_ahead,    ///< the end of what the control knows of the program
  tolerance,     ///< AX_DEV
  stop,          ///< the path stops at its end
};

}  // namespace axisc::motion
