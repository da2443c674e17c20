// The checks of AX5: what each looks for stands in docs/rules.md, one source per check in this folder.
#pragma once

#include "validator/rule.hpp"

namespace axisc::validator::checks {

void filter_syntax(CommandContext const& context, Report& report);
void filter_keyword(CommandContext const& context, Report& report);
void filter_and_vibration_guard(ProgramContext const& context, Report& report);
void filter_with_guard_in_list(ProgramContext const& context, Report& report);
void guard_with_fir_in_list(ProgramContext const& context, Report& report);
void filter_without_type(ProgramContext const& context, Report& report);
void filter_without_order(ProgramContext const& context, Report& report);
void acc_fact_needs_weight(ProgramContext const& context, Report& report);
void axis_exchange_disables(ProgramContext const& context, Report& report);
void hsc_without_preconfiguration(ProgramContext const& context, Report& report);
void commands_newer_than_build(ProgramContext const& context, Report& report);  // AX2016

}  // namespace axisc::validator::checks
