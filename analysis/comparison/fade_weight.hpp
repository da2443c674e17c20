// How the runtime changes over from one kernel to another.
#pragma once

#include <cstddef>

namespace axisc::comparison {

/// w = t^3 (10 - 15 t + 6 t^2), t = position / length; the first cycle of a change-over has position 1.
[[nodiscard]] inline double fade_weight(std::size_t position, std::size_t length) {
  double const t = static_cast<double>(position) / static_cast<double>(length);
  return t * t * t * (10 + t * (6 * t - 15));
}

}  // namespace axisc::comparison
