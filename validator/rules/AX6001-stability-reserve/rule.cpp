#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/sentences.hpp"

namespace axisc::validator::says {

constexpr Sentence headline{"the stability reserve of `{filter}` is too small: {reserve}",
                            "die Stabilitätsreserve von `{filter}` ist zu klein: {reserve}"};
constexpr Sentence label{"largest pole radius 1 - {reserve}", "größter Polradius 1 - {reserve}"};
constexpr Sentence limit{"limit: pole radius ≤ 1 - 1e-09; the filter is too slow for this cycle time",
                         "Grenze: Polradius ≤ 1 - 1e-09; der Filter ist für diese Zykluszeit zu langsam"};
constexpr Sentence frequency_here{"the frequency is set here", "hier wird die Frequenz gesetzt"};
constexpr Sentence time_here{"the time constant is set here", "hier wird die Zeitkonstante gesetzt"};
constexpr Sentence help_frequency{"raise `{parameter}`", "`{parameter}` erhöhen"};
constexpr Sentence help_time{"shorten `{parameter}`", "`{parameter}` verkürzen"};

}  // namespace axisc::validator::says

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
  Finding& finding = report.add(
      filter.anchor(filter.enable),
      {says::headline, {{"filter", filter_name(filter)}, {"reserve", format_rounded(reserve, 2)}}});
  finding.label = Message{says::label, {{"reserve", format_rounded(reserve, 2)}}};
  finding.notes.push_back({says::limit, {}});
  if (cause.value_place()) {
    finding.related.push_back(
        {*cause.value_place(), {by_frequency ? says::frequency_here : says::time_here, {}}});
  }
  finding.help.push_back(
      {by_frequency ? says::help_frequency : says::help_time, {{"parameter", parameter_name(cause)}}});
  react(finding, {says::filter_reaction_refused, {}});
}

}  // namespace

extern constinit Rule const ax6001{
    .code = Code{6001},
    .name = "stability-reserve",
    .control = "50564",
    .parameters =
        "filters[].fg_f0 filters[].time_constant filters[].guete filters[].type "
        "filters[].prototype filters[].order filters[].enable",
    .needs = Needs::cycle_time,
    .check = stability_reserve,
};

}  // namespace axisc::validator::checks
