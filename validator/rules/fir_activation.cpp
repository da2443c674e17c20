// AX3020 and AX3021: FIR filters that cannot work, because type or order is missing.
#include "validator/fir_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/kernel_checks.hpp"

namespace axisc::validator::checks {

void fir_without_type(AxisContext const& axis, Report& report) {
  FirView const& fir = axis.fir;
  if (fir.enable.unusable || fir.type.unusable) return;
  if (!fir.enable.value.flag() || fir.type.value.number != 0) return;
  Finding& finding = report.add(fir.anchor(fir.type), {Text::ax3020, {}});
  finding.notes.push_back({Text::ax3020_types, {{"p_axis", parameter_number(fir.type)}}});
  note_default(finding, fir.type);
  finding.help.push_back({Text::ax3020_help, {}});
  react(finding, "110634/51043", {Text::kernel_reaction_not_active, {}});
}

void fir_without_order(AxisContext const& axis, Report& report) {
  FirView const& fir = axis.fir;
  if (!fir.configured() || fir.order.unusable || fir.order_time.unusable) return;
  if (fir.order.value.number > 0 || fir.order_time.value.number > 0) return;
  if (program_gives_order(axis.machine, axis.index)) return;
  Finding& finding = report.add(fir.anchor(fir.order), {Text::ax3021, {}});
  finding.notes.push_back(
      {Text::ax3021_limit,
       {{"order_number", parameter_number(fir.order)}, {"time_number", parameter_number(fir.order_time)}}});
  finding.help.push_back({Text::ax3021_help, {}});
  react(finding, "50989", {Text::kernel_reaction_not_active, {}});
}

}  // namespace axisc::validator::checks
