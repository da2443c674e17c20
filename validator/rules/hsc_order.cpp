// AX3006 and AX3018: HSC filters that no order results for.
#include "validator/hsc_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/kernel_checks.hpp"

namespace axisc::validator::checks {

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
  finding.label = Message{Text::filter_time_in_cycles,
                          {{"time", microseconds(time.value.number)},
                           {"milliseconds", milliseconds(time.value.number)},
                           {"cycles", number(cycles)},
                           {"cycle", microseconds(cycle_time.microseconds())}}};
  finding.notes.push_back({Text::ax3006_limit,
                           {{"p_axis", parameter_number(time)},
                            {"shortest", microseconds(cycle_time.microseconds())},
                            {"longest", microseconds(longest)}}});
  note_default(finding, time);
  finding.help.push_back({Text::ax3006_help, {{"parameter", parameter_name(filter.order)}}});
  react(finding, "50910", {Text::kernel_reaction_not_active, {}});
}

void novib_without_order(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (hsc_type(filter) != HscType::novib || filter.order.unusable || filter.order.value.number > 0) return;
  Finding& finding =
      report.add(filter.anchor(filter.order), {Text::ax3018, {{"filter", filter_name(filter)}}});
  finding.notes.push_back({Text::ax3018_limit, {{"p_axis", parameter_number(filter.order)}}});
  note_default(finding, filter.order);
  finding.help.push_back({Text::ax3018_help, {{"parameter", parameter_name(filter.order)}}});
  react(finding, "", {Text::kernel_reaction_not_active, {}});
}

}  // namespace axisc::validator::checks
