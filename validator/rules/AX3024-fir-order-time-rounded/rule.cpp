#include "validator/engine/rule.hpp"

#include "validator/views/fir_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/fir_order_time.hpp"

#include <cmath>

namespace axisc::validator::checks {
namespace {

void fir_order_time_rounded(AxisContext const& axis, Report& report) {
  FirView const& fir = axis.fir;
  if (!uses_order_time(fir) || is_too_short(fir, axis.cycle_time) || is_too_long(fir, axis.cycle_time)) {
    return;
  }
  double const nanoseconds = fir.order_time.value.number * 1000;
  if (std::fmod(nanoseconds, axis.cycle_time.nanoseconds) == 0) return;
  std::string const order = number(fir.resulting_order(axis.cycle_time));
  Finding& finding = report.add(fir.order_time, {Text::ax3024, {{"order", order}}});
  finding.label = time_in_cycles(fir.order_time.value.number, axis.cycle_time);
  finding.notes.push_back({Text::ax3024_formula, {{"p_axis", parameter_number(fir.order_time)}}});
  react(finding, {Text::ax3024_reaction, {}}, order);
}

}  // namespace

extern constinit Rule const ax3024{
    .code = Code{3024},
    .name = "fir-order-time-rounded",
    .severity = Severity::note,
    .needs = Needs::cycle_time,
    .precedence = Precedence::after_family,
    .check = fir_order_time_rounded,
};

}  // namespace axisc::validator::checks
