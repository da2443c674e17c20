#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/control_numbers.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/fir_order_time.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/sentences.hpp"
#include "validator/views/fir_view.hpp"

namespace axisc::validator::checks::ax3022::says {

constexpr Sentence fir_order_time_range_short{"the order given as time is shorter than one NC cycle",
                                              "die als Zeit angegebene Ordnung ist kürzer als ein NC-Zyklus"};
constexpr Sentence fir_order_time_range_long{
    "the order given as time is longer than {order} NC cycles",
    "die als Zeit angegebene Ordnung ist länger als {order} NC-Zyklen"};
constexpr Sentence limit{"{p_axis}: T = {shortest} ≤ order_time ≤ {order} T = {longest}",
                         "{p_axis}: T = {shortest} ≤ order_time ≤ {order} T = {longest}"};
constexpr Sentence help{"`{parameter}` gives the order in cycles, 1 to {order}",
                        "`{parameter}` gibt die Ordnung in Zyklen an, 1 bis {order}"};

}  // namespace axisc::validator::checks::ax3022::says

namespace axisc::validator::checks::ax3022 {
namespace {

// Message numbers of the control.
constexpr std::string_view order_too_low = "50910";
constexpr std::string_view order_clipped = "50911";

void fir_order_time_range(AxisContext const& axis, Report& report) {
  FirView const& fir = axis.fir;
  if (!uses_order_time(fir)) return;
  bool const short_one = is_too_short(fir, axis.cycle_time);
  if (!short_one && !is_too_long(fir, axis.cycle_time)) return;
  std::string const order = format_exact(fir.longest_order());
  double const cycle = axis.cycle_time.microseconds();
  Finding& finding = report.add(
      fir.order_time,
      {short_one ? says::fir_order_time_range_short : says::fir_order_time_range_long, {{"order", order}}});
  finding.label = time_in_cycles(fir.order_time.value.number, axis.cycle_time);
  finding.notes.push_back({says::limit,
                           {{"p_axis", parameter_number(fir.order_time)},
                            {"order", order},
                            {"shortest", microseconds(cycle)},
                            {"longest", microseconds(cycle * fir.longest_order())}}});
  double const time = fir.order_time.value.number;
  double const as_milliseconds = axis.cycle_time.cycles({time * 1000});
  if (short_one && as_milliseconds >= 1 && as_milliseconds <= fir.longest_order()) {
    finding.help.push_back({validator::says::milliseconds_meant,
                            {{"value", number(time)},
                             {"replacement", parameter_name(fir.order_time) + " " + number(time * 1000)}}});
  }
  finding.help.push_back({says::help, {{"parameter", parameter_name(fir.order)}, {"order", order}}});
  if (short_one) {
    react(finding, order_too_low, {validator::says::kernel_reaction_not_active, {}});
  } else {
    react(finding, order_clipped, {validator::says::filter_reaction_clipped, {}}, order);
  }
}

}  // namespace

extern constinit Rule const rule{
    .control = control_numbers<order_too_low, order_clipped>,
    .parameters = "filter_fir.order_time filter_fir.order filter_fir.type",
    .needs = Needs::cycle_time,
    .check = fir_order_time_range,
};

}  // namespace axisc::validator::checks::ax3022
