// How fast an axis may be driven, as its lists say.
#pragma once

#include "configuration/machine/path_dynamics.hpp"
#include "validator/values/effective_values.hpp"

namespace axisc::validator {

/// The values of gear 0 as the control uses them: no acceleration is above P-AXIS-00008, no ramp time below
/// P-AXIS-00201 (110276, 110406), G00 no faster than P-AXIS-00212, and an acceleration of the slope STEP that
/// is 0 for slowing down is that for speeding up.
[[nodiscard]] machine::AxisDynamics axis_dynamics(EffectiveValues const& values);

}  // namespace axisc::validator
