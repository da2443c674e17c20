#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/views/fir_view.hpp"

namespace axisc::validator::checks::ax3021::says {

constexpr Sentence headline{"the FIR filter has a type, but no order: it cannot work",
                            "der FIR-Filter hat einen Typ, aber keine Ordnung: er kann nicht wirken"};
constexpr Sentence limit{
    "a FIR filter works with order > 0 ({order_number}) or order_time ≥ T ({time_number})",
    "ein FIR-Filter wirkt mit order > 0 ({order_number}) oder order_time ≥ T ({time_number})"};
constexpr Sentence help{"set `filter_fir.order`, or give it in the NC program: `#FILTER ON [ORDER=20]`",
                        "`filter_fir.order` setzen, oder im NC-Programm angeben: `#FILTER ON [ORDER=20]`"};

}  // namespace axisc::validator::checks::ax3021::says

namespace axisc::validator::checks::ax3021 {
namespace {

void fir_without_order(AxisContext const& axis, Report& report) {
  FirView const& fir = axis.fir;
  if (!fir.configured() || fir.order.unusable || fir.order_time.unusable) return;
  if (fir.order.value.number > 0 || fir.order_time.value.number > 0) return;
  if (program_gives_order(axis.machine, axis.index)) return;
  Finding& finding = report.add(fir.anchor(fir.order), {says::headline, {}});
  finding.notes.push_back(
      {says::limit,
       {{"order_number", parameter_number(fir.order)}, {"time_number", parameter_number(fir.order_time)}}});
  finding.help.push_back({says::help, {}});
  react(finding, {validator::says::kernel_reaction_not_active, {}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .control = "50989",
    .parameters = "filter_fir.order filter_fir.order_time filter_fir.type filter_fir.enable",
    .check = fir_without_order,
};

}  // namespace axisc::validator::checks::ax3021
