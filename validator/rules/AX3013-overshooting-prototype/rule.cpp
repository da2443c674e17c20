#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/step_overshoot.hpp"

namespace axisc::validator::checks::ax3013::says {

constexpr Sentence headline{
    "a low-pass `{prototype}` of order {order} overshoots: it does not suit position setpoints",
    "ein Tiefpass `{prototype}` der Ordnung {order} schwingt über: für Positionssollwerte ungeeignet"};
constexpr Sentence butterworth{"{p_axis}: the overshoot of BUTTERWORTH grows with the order",
                               "{p_axis}: das Überschwingen von BUTTERWORTH wächst mit der Ordnung"};
constexpr Sentence bessel{
    "{p_axis}: BESSEL overshoots slightly above order 1; not recommended for positions",
    "{p_axis}: BESSEL schwingt über Ordnung 1 leicht über; für Positionen nicht empfohlen"};
constexpr Sentence help{"`CRIT_DAMPING` does not overshoot", "`CRIT_DAMPING` schwingt nicht über"};
constexpr Sentence help_lower{
    "lower `{parameter}`: above 0.1/T = {limit} Hz `CRIT_DAMPING` overshoots, too, here by {overshoot} %",
    "`{parameter}` verringern: über 0,1/T = {limit} Hz schwingt auch `CRIT_DAMPING` über, hier um "
    "{overshoot} %"};

}  // namespace axisc::validator::checks::ax3013::says

namespace axisc::validator::checks::ax3013 {
namespace {

constexpr double noticeable = 1e-3;

/// The overshoot with `CRIT_DAMPING`: close to half the sampling rate the bilinear transform makes poles
/// negative.
Message help_of(FilterContext const& context) {
  auto specification = context.axis.designs.specification(context.filter);
  if (!specification) return {says::help, {}};
  specification->prototype = design::Prototype::critical_damping;
  double const overshoot = step_overshoot(*specification, context.axis.cycle_time);
  if (overshoot < noticeable) return {says::help, {}};
  return {says::help_lower,
          {{"parameter", parameter_name(context.filter.frequency)},
           {"limit", number(0.2 * context.axis.cycle_time.nyquist().value)},
           {"overshoot", percent(overshoot)}}};
}

void overshooting_prototype(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (!filter.active() || filter.port != FilterPort::setpoint) return;
  if (filter.standard_type != design::FilterType::lowpass) return;
  if (filter.prototype.unusable || filter.order.value.number <= 1) return;
  auto const prototype = static_cast<design::Prototype>(static_cast<int>(filter.prototype.value.number));
  if (prototype == design::Prototype::critical_damping) return;

  bool const butterworth = prototype == design::Prototype::butterworth;
  Finding& finding = report.add(
      filter.anchor(filter.prototype),
      {says::headline,
       {{"prototype", symbol_word(filter.prototype)}, {"order", number(filter.order.value.number)}}});
  if (auto const overshoot = step_overshoot(context)) {
    finding.label = overshoot_label(*overshoot);
  }
  finding.notes.push_back(
      {butterworth ? says::butterworth : says::bessel, {{"p_axis", parameter_number(filter.prototype)}}});
  finding.help.push_back(help_of(context));
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters = "filter[].prototype filter[].type filter[].order filter[].enable",
    .needs = Needs::cycle_time,
    .check = overshooting_prototype,
};

}  // namespace axisc::validator::checks::ax3013
