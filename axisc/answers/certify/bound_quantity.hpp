// Bounds with fewer digits that are still bounds.
#pragma once

#include "presentation/quantity.hpp"

namespace axisc {

/// As many digits of an upper bound, rounded upwards; the last digits of what is stored are so already.
[[nodiscard]] presentation::Quantity upper_bound(double value, int digits,
                                                 presentation::Unit unit = presentation::Unit::none);
/// Of a lower one, rounded downwards.
[[nodiscard]] presentation::Quantity lower_bound(double value, int digits);

}  // namespace axisc
