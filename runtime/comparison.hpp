// Compares two images by the runtimes made from them: neither image is read.
#pragma once

#include "runtime/runtime_object.hpp"

namespace axisc::runtime {

/// Number, numbers and types of the axes, and their names where both images have them.
[[nodiscard]] bool same_axes(axisrt const& a, axisrt const& b);

/// Every number of Improved Position Control, bit by bit.
[[nodiscard]] bool same_controls(axisrt const& a, axisrt const& b);

}  // namespace axisc::runtime
