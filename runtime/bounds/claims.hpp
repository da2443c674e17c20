// What a record claims, compared with what follows from the stored coefficients.
#pragma once

#include "runtime/bounds/bound_record.hpp"

#include <stdint.h>

namespace axisc::runtime::bounds {

/// The fields of a record that may fail.
enum class Claim : uint32_t {
  none,  ///< all are true
  key,   ///< another chain, kernel or stage is due here
  flags,
  cycles,
  gain_low,
  gain_high,
  overshoot_high,
  distance_high,
  radius_high,
  rounding_increment,
  rounding_position,
  state_increment,
  state_position,
  rest_cycles,
  limit_error
};

/// The first field of `claimed` that is below what was `computed` (gain_low: above). More than what was
/// computed is true as well; what was not certain must not be claimed.
[[nodiscard]] Claim failing_claim(BoundRecord const& claimed, BoundRecord const& computed);

/// Name of a field; "none" for Claim::none.
[[nodiscard]] char const* name_of(Claim claim);

}  // namespace axisc::runtime::bounds
