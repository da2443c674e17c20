// The checks of AX3 and AX6: what each looks for stands in docs/rules.md, one source per check in this
// folder.
#pragma once

#include "validator/rule.hpp"

namespace axisc::validator::checks {

void filter_order_for_type(AxisContext const& axis, Report& report);
void frequency_above_nyquist(AxisContext const& axis, Report& report);
void frequency_zero(AxisContext const& axis, Report& report);
void time_constant_below_cycle(FilterContext const& context, Report& report);
void delay_too_long(FilterContext const& context, Report& report);
void enabled_without_order(FilterContext const& context, Report& report);
void order_without_enable(FilterContext const& context, Report& report);
void unused_parameter(AxisContext const& axis, Report& report);
void undocumented_type(FilterContext const& context, Report& report);
void overshooting_prototype(FilterContext const& context, Report& report);
void allpass_prototype(FilterContext const& context, Report& report);
void share_zero(AxisContext const& axis, Report& report);
void blocks_constant_part(FilterContext const& context, Report& report);
void interface_filter_invalid_default(FilterContext const& context, Report& report);
void interface_disabled(FilterContext const& context, Report& report);

void stability_reserve(FilterContext const& context, Report& report);
void long_settling(AxisContext const& axis, Report& report);
void bandstop_overshoot(FilterContext const& context, Report& report);
void peak_gain(AxisContext const& axis, Report& report);

}  // namespace axisc::validator::checks
