#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/step_overshoot.hpp"

namespace axisc::validator::checks::ax6004::says {

constexpr Sentence headline{"the band-stop `{filter}` overshoots by {overshoot} %",
                            "die Bandsperre `{filter}` schwingt um {overshoot} % über"};
constexpr Sentence monitoring{
    "{p_axis}: `{parameter}` lets the velocity exceed its limit by {limit} % before it responds",
    "{p_axis}: `{parameter}` lässt {limit} % Überschreitung der Geschwindigkeit zu, bevor sie anspricht"};
constexpr Sentence help{"reduce the dynamics of the axis, or allow slightly more with {p_axis}",
                        "die Achsdynamik verringern, oder mit {p_axis} geringfügig mehr zulassen"};

}  // namespace axisc::validator::checks::ax6004::says

namespace axisc::validator::checks::ax6004 {
namespace {

constexpr double noticeable = 0.01;

void bandstop_overshoot(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (!filter.active() || filter.port != FilterPort::setpoint) return;
  if (filter.standard_type != design::FilterType::bandstop) return;
  auto const overshoot = step_overshoot(context);
  if (!overshoot || *overshoot <= noticeable) return;
  Finding& finding =
      report.add(filter.anchor(filter.type),
                 {says::headline, {{"filter", filter_name(filter)}, {"overshoot", percent(*overshoot)}}});
  finding.label = overshoot_label(*overshoot);
  EffectiveValue const& limit = context.axis.values.at("kenngr.dyn_monitoring_v_err");
  if (!limit.unusable) {
    finding.notes.push_back({says::monitoring,
                             {{"p_axis", parameter_number(limit)},
                              {"parameter", parameter_name(limit)},
                              {"limit", percent(limit.value.number / 1000)}}});
  }
  finding.help.push_back({says::help, {{"p_axis", parameter_number(limit)}}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters =
        "filter[].fg_f0 filter[].guete filter[].type filter[].prototype filter[].order filter[].enable "
        "filter[].share_percent",
    .needs = Needs::cycle_time,
    .check = bandstop_overshoot,
};

}  // namespace axisc::validator::checks::ax6004
