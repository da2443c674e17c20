// The checks of Improved Position Control: what each looks for stands in docs/rules.md.
#pragma once

#include "validator/rule.hpp"

namespace axisc::validator::checks {

void ipc_parameter_missing(AxisContext const& axis, Report& report);  // AX3030
void ipc_damping_range(AxisContext const& axis, Report& report);      // AX3031
void ipc_weight_limited(AxisContext const& axis, Report& report);     // AX3032
void ipc_without_limit(AxisContext const& axis, Report& report);      // AX3033
void ipc_frequencies_close(AxisContext const& axis, Report& report);  // AX3034
void ipc_no_active_stage(AxisContext const& axis, Report& report);    // AX3035
void ipc_phase_lag(AxisContext const& axis, Report& report);          // AX3036
void ipc_low_damping(AxisContext const& axis, Report& report);        // AX3037
void ipc_drive_type(AxisContext const& axis, Report& report);         // AX3038
void ipc_mixed_generations(AxisContext const& axis, Report& report);  // AX3039
void ipc_no_bandpass(AxisContext const& axis, Report& report);        // AX3042
void ipc_operation_mode(AxisContext const& axis, Report& report);     // AX3043
void ipc_scaling_missing(AxisContext const& axis, Report& report);    // AX4016

}  // namespace axisc::validator::checks
