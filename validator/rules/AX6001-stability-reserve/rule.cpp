#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/proved_chain.hpp"
#include "validator/rules/sentences.hpp"

#include <algorithm>
#include <utility>

namespace axisc::validator::checks::ax6001::says {

constexpr Sentence headline{"the stability reserve of `{filter}` is too small: {reserve}",
                            "die Stabilitätsreserve von `{filter}` ist zu klein: {reserve}"};
constexpr Sentence label{"largest pole radius 1 - {reserve}", "größter Polradius 1 - {reserve}"};
constexpr Sentence unloadable{"rounded to the numbers of an image, `{filter}` is not stable",
                              "auf die Zahlen eines Abbilds gerundet ist `{filter}` nicht stabil"};
constexpr Sentence unloadable_label{"a pole next to -1", "ein Pol bei -1"};
constexpr Sentence limit_fast{
    "limit: pole radius ≤ 1 - 1e-09; the frequency is too close to half the sampling rate, {nyquist} Hz",
    "Grenze: Polradius ≤ 1 - 1e-09; die Frequenz liegt zu nahe an der halben Abtastrate, {nyquist} Hz"};
constexpr Sentence help_lower{"lower `{parameter}`", "`{parameter}` verringern"};
constexpr Sentence help_quality{"lower `{parameter}` or raise `{quality}`",
                                "`{parameter}` verringern oder `{quality}` erhöhen"};
constexpr Sentence limit{"limit: pole radius ≤ 1 - 1e-09; the filter is too slow for this cycle time",
                         "Grenze: Polradius ≤ 1 - 1e-09; der Filter ist für diese Zykluszeit zu langsam"};
constexpr Sentence frequency_here{"the frequency is set here", "hier wird die Frequenz gesetzt"};
constexpr Sentence time_here{"the time constant is set here", "hier wird die Zeitkonstante gesetzt"};
constexpr Sentence help_frequency{"raise `{parameter}`", "`{parameter}` erhöhen"};
constexpr Sentence help_time{"shorten `{parameter}`", "`{parameter}` verkürzen"};

}  // namespace axisc::validator::checks::ax6001::says

namespace axisc::validator::checks::ax6001 {
namespace {

/// The numbers that an image stores decide. Only close to the limits do those of the quick design differ.
bool can_be_stored(FilterContext const& context, design::FilterDesign const& quick) {
  constexpr double certain = 1e-12;
  bool const is_clear =
      std::all_of(quick.sections.begin(), quick.sections.end(), [](design::IncrementSection const& section) {
        auto const [p, q, k, b] = section;
        return design::is_loadable(section) && std::min({k, b, 2 - b, 4 - k - 2 * b}) > certain;
      });
  if (is_clear) return true;
  auto const exact = design::design_filter(*context.axis.designs.specification(context.filter),
                                           context.axis.cycle_time, design::Precision::exact);
  return std::all_of(exact.sections.begin(), exact.sections.end(), design::is_loadable);
}

void stability_reserve(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  design::FilterDesign const* const design = context.axis.designs.of(filter);
  if (design == nullptr) return;
  double const reserve = 1 - design->pole_radius;
  bool const is_small = reserve < smallest_reserve;
  if (!is_small && can_be_stored(context, *design)) return;
  bool const by_frequency = design::uses_frequency(*filter.standard_type);
  EffectiveValue const& cause = by_frequency ? filter.frequency : filter.time_constant;
  Message headline{says::unloadable, {{"filter", filter_name(filter)}}};
  if (is_small) {
    headline = {says::headline, {{"filter", filter_name(filter)}, {"reserve", format_rounded(reserve, 2)}}};
  }
  Finding& finding = report.add(filter.anchor(filter.enable), std::move(headline));
  finding.label = is_small ? Message{says::label, {{"reserve", format_rounded(reserve, 2)}}}
                           : Message{says::unloadable_label, {}};
  double const nyquist = context.axis.cycle_time.nyquist().value;
  bool const too_fast = by_frequency && filter.frequency.value.number > nyquist / 2;
  finding.notes.push_back(too_fast ? Message{says::limit_fast, {{"nyquist", number(nyquist)}}}
                                   : Message{says::limit, {}});
  if (cause.value_place()) {
    finding.related.push_back(
        {*cause.value_place(), {by_frequency ? says::frequency_here : says::time_here, {}}});
  }
  SentenceRef help = by_frequency ? says::help_frequency : says::help_time;
  if (too_fast) help = design::uses_quality(*filter.standard_type) ? says::help_quality : says::help_lower;
  finding.help.push_back(
      {help, {{"parameter", parameter_name(cause)}, {"quality", parameter_name(filter.quality)}}});
  react(finding, {validator::says::filter_reaction_refused, {}});
}

}  // namespace

extern constinit Rule const rule{
    .control = "50564",
    .parameters =
        "filters[].fg_f0 filters[].time_constant filters[].guete filters[].type filters[].prototype "
        "filters[].order filters[].enable",
    .needs = Needs::cycle_time,
    .check = stability_reserve,
};

}  // namespace axisc::validator::checks::ax6001
