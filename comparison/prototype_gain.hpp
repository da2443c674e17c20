// Gain of the low-pass prototypes of docs/filters.md, which have half the power at 1.
#pragma once

#include "design/filter_specification.hpp"

namespace axisc::comparison {

/// The frequency at which the prototype's power is `power`, between 0 and 1.
[[nodiscard]] double frequency_with_power(design::Prototype prototype, std::uint32_t order, double power);

/// Of Bessel prototypes: the frequency of half the power where the delay at 0 is 1.
[[nodiscard]] double bessel_cutoff(std::uint32_t order);

}  // namespace axisc::comparison
