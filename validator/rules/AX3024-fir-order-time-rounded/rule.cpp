#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/fir_order_time.hpp"
#include "validator/views/fir_view.hpp"

#include <cmath>

namespace axisc::validator::checks::ax3024::says {

constexpr Sentence headline{
    "`filter_fir.order_time` is not a whole number of cycles: the order becomes {order}",
    "`filter_fir.order_time` ist kein ganzes Vielfaches der Zykluszeit: die Ordnung wird {order}"};
constexpr Sentence formula{"{p_axis}: order = order_time / T, rounded",
                           "{p_axis}: order = order_time / T, gerundet"};
constexpr Sentence reaction{"the time is rounded to whole cycles", "die Zeit wird auf ganze Zyklen gerundet"};
constexpr Sentence help{"`{parameter} {time}` says the same in whole cycles",
                        "`{parameter} {time}` sagt dasselbe in ganzen Zyklen"};

}  // namespace axisc::validator::checks::ax3024::says

namespace axisc::validator::checks::ax3024 {
namespace {

void fir_order_time_rounded(AxisContext const& axis, Report& report) {
  FirView const& fir = axis.fir;
  if (!uses_order_time(fir) || is_too_short(fir, axis.cycle_time) || is_too_long(fir, axis.cycle_time)) {
    return;
  }
  double const nanoseconds = fir.order_time.value.number * 1000;
  if (std::fmod(nanoseconds, axis.cycle_time.nanoseconds) == 0) return;
  std::string const order = format_exact(fir.resulting_order(axis.cycle_time));
  Finding& finding = report.add(fir.order_time, {says::headline, {{"order", order}}});
  finding.label = time_in_cycles(fir.order_time.value.number, axis.cycle_time);
  finding.notes.push_back({says::formula, {{"p_axis", parameter_number(fir.order_time)}}});
  double const time = fir.resulting_order(axis.cycle_time) * axis.cycle_time.microseconds();
  if (time == std::floor(time)) {
    finding.help.push_back(
        {says::help, {{"parameter", parameter_name(fir.order_time)}, {"time", format_exact(time)}}});
  }
  react(finding, {says::reaction, {}}, order);
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .parameters = "filter_fir.order_time filter_fir.order filter_fir.type",
    .needs = Needs::cycle_time,
    .precedence = Precedence::after_family,
    .check = fir_order_time_rounded,
};

}  // namespace axisc::validator::checks::ax3024
