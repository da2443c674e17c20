#include "validator/engine/rule.hpp"

#include "validator/views/hsc_view.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
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
  Finding& finding = report.add(filter.anchor(time), {Text::ax3006, {{"filter", filter_name(filter)}}});
  finding.label = time_in_cycles(time.value.number, cycle_time);
  finding.notes.push_back({Text::ax3006_limit,
                           {{"p_axis", parameter_number(time)},
                            {"shortest", microseconds(cycle_time.microseconds())},
                            {"longest", microseconds(longest)}}});
  note_default(finding, time);
  finding.help.push_back({Text::ax3006_help, {{"parameter", parameter_name(filter.order)}}});
  react(finding, {Text::kernel_reaction_not_active, {}});
}

}  // namespace

extern constinit Rule const ax3006{
    .code = Code{3006},
    .name = "hsc-time-out-of-range",
    .control = "50910",
    .needs = Needs::cycle_time,
    .check = hsc_time_out_of_range,
};

}  // namespace axisc::validator::checks
