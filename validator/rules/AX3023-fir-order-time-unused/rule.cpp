#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/views/fir_view.hpp"

namespace axisc::validator::checks::ax3023::says {

constexpr Sentence headline{
    "`filter_fir.order` {order} takes precedence: `filter_fir.order_time` is not used",
    "`filter_fir.order` {order} hat Vorrang: `filter_fir.order_time` wird nicht verwendet"};
constexpr Sentence label{"{time} have no effect", "{time} haben keine Wirkung"};
constexpr Sentence order_here{"the order is set here", "hier wird die Ordnung gesetzt"};
constexpr Sentence help{"remove the line that is not meant", "die nicht gemeinte Zeile entfernen"};

}  // namespace axisc::validator::checks::ax3023::says

namespace axisc::validator::checks::ax3023 {
namespace {

void fir_order_time_unused(AxisContext const& axis, Report& report) {
  FirView const& fir = axis.fir;
  if (!fir.configured() || fir.order.unusable || fir.order_time.unusable) return;
  if (!(fir.order.value.number > 0) || !(fir.order_time.value.number > 0)) return;
  Finding& finding =
      report.add(fir.order_time, {says::headline, {{"order", number(fir.order.value.number)}}});
  finding.label = Message{says::label, {{"time", microseconds(fir.order_time.value.number)}}};
  if (fir.order.value_place()) {
    finding.related.push_back({*fir.order.value_place(), {says::order_here, {}}});
  }
  finding.help.push_back({says::help, {}});
  react(finding, {validator::says::filter_value_ignored, {}},
        "filter_fir.order " + number(fir.order.value.number).written());
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters = "filter_fir.order_time filter_fir.order filter_fir.type",
    .precedence = Precedence::after_family,
    .check = fir_order_time_unused,
};

}  // namespace axisc::validator::checks::ax3023
