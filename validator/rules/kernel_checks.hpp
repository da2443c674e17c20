// The checks of linear-phase filters, HSC and FIR: what each looks for stands in docs/rules.md.
#pragma once

#include "validator/rule.hpp"

namespace axisc::validator::checks {

void hsc_time_out_of_range(FilterContext const& context, Report& report);    // AX3006
void hsc_prototype_and_type(FilterContext const& context, Report& report);   // AX3010
void hsc_enabled_permanently(FilterContext const& context, Report& report);  // AX3011
void novib_frequency_too_low(FilterContext const& context, Report& report);  // AX3016
void novib_without_order(FilterContext const& context, Report& report);      // AX3018
void fir_without_type(AxisContext const& axis, Report& report);              // AX3020
void fir_without_order(AxisContext const& axis, Report& report);             // AX3021
void fir_order_time_range(AxisContext const& axis, Report& report);          // AX3022
void fir_order_time_unused(AxisContext const& axis, Report& report);         // AX3023
void fir_order_time_rounded(AxisContext const& axis, Report& report);        // AX3024
void fir_delay_share(AxisContext const& axis, Report& report);               // AX3025

void hsc_not_first(FilterContext const& context, Report& report);        // AX4001
void hsc_more_than_one(FilterContext const& context, Report& report);    // AX4002
void hsc_on_spindle(FilterContext const& context, Report& report);       // AX4003
void delay_not_last(FilterContext const& context, Report& report);       // AX4004
void fir_with_hsc(AxisContext const& axis, Report& report);              // AX4005
void fir_with_vibration_guard(AxisContext const& axis, Report& report);  // AX4006
void hsc_superseded(FilterContext const& context, Report& report);       // AX4007

}  // namespace axisc::validator::checks
