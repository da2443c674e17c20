// The two instances of the design templates.
#pragma once

#include "design/filter_design.hpp"
#include "design/oscillator.hpp"

namespace axisc::design {

/// In double: for rules.
[[nodiscard]] FilterDesign design_quick(FilterSpecification const& specification, CycleTime cycle_time);
[[nodiscard]] FilterDesign design_quick(OscillatorSpecification const& specification, CycleTime cycle_time);
/// With 50 decimal digits, and no function of the host's mathematics library: for images.
[[nodiscard]] FilterDesign design_exact(FilterSpecification const& specification, CycleTime cycle_time);
[[nodiscard]] FilterDesign design_exact(OscillatorSpecification const& specification, CycleTime cycle_time);

}  // namespace axisc::design
