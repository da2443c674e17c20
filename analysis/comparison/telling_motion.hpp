// Which motion would tell readings apart that a recording does not.
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

/// What an axis can be told to do, in units of the recording.
struct Motions {
  double velocity = 0;  ///< per cycle
  double step = 0;
};

/// The gentlest motion in which every two of `readings` differ by clearly more than rounding to the recording's resolution hides,
/// whatever the offset of the columns. None for fewer than two.
[[nodiscard]] std::optional<Motion> telling_motion(std::span<Reading const> readings,
                                                   Comparison const& comparison, Motions const& motions);

}  // namespace axisc::comparison
