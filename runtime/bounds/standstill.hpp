// B6: after how many cycles of a constant setpoint every state is 0, for good.
#pragma once

#include "runtime/bounds/response.hpp"

#include <stdint.h>

namespace axisc::runtime::bounds {

/// A section begins with states of at most 2^54 times their sizes per position (setpoints are within 2^53).
/// In each m = `shrinking` cycles they shrink to 2^-23 of what they were, until they are below 2^-500, where
/// one of the next six cycles clears them. Then the next section begins. 0 where a section is not certain to
/// shrink.
[[nodiscard]] uint64_t rest_cycles(Chain const& chain, SectionSizes const* sizes, KernelPart const& kernel);

}  // namespace axisc::runtime::bounds
