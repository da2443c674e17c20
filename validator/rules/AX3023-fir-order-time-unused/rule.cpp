#include "validator/engine/rule.hpp"

#include "validator/views/fir_view.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

void fir_order_time_unused(AxisContext const& axis, Report& report) {
  FirView const& fir = axis.fir;
  if (!fir.configured() || fir.order.unusable || fir.order_time.unusable) return;
  if (!(fir.order.value.number > 0) || !(fir.order_time.value.number > 0)) return;
  Finding& finding = report.add(fir.order_time, {Text::ax3023, {{"order", number(fir.order.value.number)}}});
  finding.label = Message{Text::ax3023_label, {{"time", microseconds(fir.order_time.value.number)}}};
  if (fir.order.value_place()) {
    finding.related.push_back({*fir.order.value_place(), {Text::ax3023_order_here, {}}});
  }
  react(finding, {Text::filter_value_ignored, {}}, "filter_fir.order " + number(fir.order.value.number));
}

}  // namespace

extern constinit Rule const ax3023{
    .code = Code{3023},
    .name = "fir-order-time-unused",
    .severity = Severity::warning,
    .precedence = Precedence::after_family,
    .check = fir_order_time_unused,
};

}  // namespace axisc::validator::checks
