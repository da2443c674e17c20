#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

constexpr double smallest_reserve = 1e-9;

void stability_reserve(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  design::FilterDesign const* const design = context.axis.designs.of(filter);
  if (design == nullptr) return;
  double const reserve = 1 - design->pole_radius;
  if (reserve >= smallest_reserve) return;
  bool const by_frequency = design::uses_frequency(*filter.standard_type);
  EffectiveValue const& cause = by_frequency ? filter.frequency : filter.time_constant;
  Finding& finding =
      report.add(filter.anchor(filter.enable),
                 {Text::ax6001, {{"filter", filter_name(filter)}, {"reserve", format_rounded(reserve, 2)}}});
  finding.label = Message{Text::ax6001_label, {{"reserve", format_rounded(reserve, 2)}}};
  finding.notes.push_back({Text::ax6001_limit, {}});
  if (cause.value_place()) {
    finding.related.push_back(
        {*cause.value_place(), {by_frequency ? Text::ax6001_frequency_here : Text::ax6001_time_here, {}}});
  }
  finding.help.push_back({by_frequency ? Text::ax6001_help_frequency : Text::ax6001_help_time,
                          {{"parameter", parameter_name(cause)}}});
  react(finding, {Text::filter_reaction_refused, {}});
}

}  // namespace

extern constinit Rule const ax6001{
    .code = Code{6001},
    .name = "stability-reserve",
    .control = "50564",
    .needs = Needs::cycle_time,
    .check = stability_reserve,
};

}  // namespace axisc::validator::checks
