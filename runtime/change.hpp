// Change from one image to another while the machine runs.
#pragma once

#include "runtime/runtime_object.hpp"

#include <stdint.h>

namespace axisc::runtime {

/// The runtime that this one is replacing at present; null if there is none.
[[nodiscard]] inline axisrt* changes_from(axisrt const& runtime) {
  return runtime.change->begun != 0 ? runtime.change->predecessor : nullptr;
}

/// w = t^3 (10 - 15 t + 6 t^2) of the present cycle of a change.
[[nodiscard]] inline double weight_of(Change const& change) {
  double const t = static_cast<double>(change.position) / static_cast<double>(change.length);
  return t * t * t * (10 + t * (6 * t - 15));
}

/// Arrays of a call, one entry for each line.
struct Call {
  double const* in;
  double* out;
  uint8_t* status;  ///< may be null
};

/// Goes one cycle further; the predecessor is dropped at the end.
void advance(Change& change);

}  // namespace axisc::runtime
