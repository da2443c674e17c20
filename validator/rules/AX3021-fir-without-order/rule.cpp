#include "validator/engine/rule.hpp"

#include "validator/views/fir_view.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

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
  react(finding, {Text::kernel_reaction_not_active, {}});
}

}  // namespace

extern constinit Rule const ax3021{
    .code = Code{3021},
    .name = "fir-without-order",
    .severity = Severity::warning,
    .control = "50989",
    .check = fir_without_order,
};

}  // namespace axisc::validator::checks
