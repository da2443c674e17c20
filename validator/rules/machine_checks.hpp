// The checks of several axes together: what each looks for stands in docs/rules.md.
#pragma once

#include "validator/rule.hpp"

namespace axisc::validator::checks {

void group_not_identical(GroupContext const& context, Report& report);       // AX4010
void group_delay_mismatch(GroupContext const& context, Report& report);      // AX4011
void gantry_slave_ipc(AxisContext const& axis, Report& report);              // AX4012
void gantry_scaling_differs(MachineContext const& context, Report& report);  // AX4013
void gantry_broken(MachineContext const& context, Report& report);           // AX4014
void axis_number(MachineContext const& context, Report& report);             // AX4015

}  // namespace axisc::validator::checks
