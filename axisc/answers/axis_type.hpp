// Types of axes in answers.
#pragma once

#include "configuration/machine/machine.hpp"
#include "presentation/value.hpp"

namespace axisc {

/// "T", for people "translatory"; "?" for a number that no type has.
[[nodiscard]] presentation::Symbol axis_type_symbol(machine::AxisType type);

}  // namespace axisc
