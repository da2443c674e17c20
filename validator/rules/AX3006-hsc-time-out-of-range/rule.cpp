#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/views/hsc_view.hpp"

namespace axisc::validator::checks::ax3006::says {

constexpr Sentence headline{"`{filter}` has no order, and its time constant gives none",
                            "`{filter}` hat keine Ordnung, und seine Zeitkonstante ergibt keine"};
constexpr Sentence limit{"{p_axis}: T = {shortest} < time_constant < 200 T = {longest} for HSC filters",
                         "{p_axis}: T = {shortest} < time_constant < 200 T = {longest} für HSC-Filter"};
constexpr Sentence help{"`{parameter}` gives the order in cycles, 1 to 200",
                        "`{parameter}` gibt die Ordnung in Zyklen an, 1 bis 200"};

}  // namespace axisc::validator::checks::ax3006::says

namespace axisc::validator::checks::ax3006 {
namespace {

void hsc_time_out_of_range(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  EffectiveValue const& time = filter.time_constant;
  if (hsc_type(filter) != HscType::mean || filter.order.unusable || time.unusable) return;
  if (filter.order.value.number > 0) return;
  design::CycleTime const cycle_time = context.axis.cycle_time;
  double const cycles = cycle_time.cycles({time.value.number});
  if (cycles > 1 && cycles < design::longest_kernel_order) return;

  double const longest = design::longest_kernel_order * cycle_time.microseconds();
  Finding& finding = report.add(filter.anchor(time), {says::headline, {{"filter", filter_name(filter)}}});
  finding.label = time_in_cycles(time.value.number, cycle_time);
  finding.notes.push_back({says::limit,
                           {{"p_axis", parameter_number(time)},
                            {"shortest", microseconds(cycle_time.microseconds())},
                            {"longest", microseconds(longest)}}});
  note_default(finding, time);
  finding.help.push_back({says::help, {{"parameter", parameter_name(filter.order)}}});
  react(finding, {validator::says::kernel_reaction_not_active, {}});
}

}  // namespace

extern constinit Rule const rule{
    .control = "50910",
    .parameters = "filter[].time_constant filter[].order filter[].type filter[].prototype",
    .needs = Needs::cycle_time,
    .check = hsc_time_out_of_range,
};

}  // namespace axisc::validator::checks::ax3006
