// A motion that tells apart readings which a recording does not.
#pragma once

#include "analysis/comparison/verdict.hpp"

#include <cstdint>
#include <optional>
#include <span>

namespace axisc::comparison {

enum class Motion : std::uint8_t {
  velocity_jump,  ///< from rest to a constant velocity and back to rest
  step,           ///< of the position
  none            ///< the readings are alike in all of them
};

/// Limits of an axis, in units of the recording.
struct Motions {
  double velocity = 0;  ///< per cycle
  double step = 0;
};

/// The gentlest motion in which every two of `readings` differ by clearly more than rounding to the
/// recording's resolution, whatever the offset of the columns. None for fewer than two.
[[nodiscard]] std::optional<Motion> telling_motion(std::span<Reading const> readings,
                                                   Comparison const& comparison, Motions const& motions);

}  // namespace axisc::comparison
