#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/group_delays.hpp"
#include "validator/views/delay_budget.hpp"

#include <cmath>

namespace axisc::validator::checks::ax4025::says {

constexpr Sentence early{
    "the velocity that is fed forward leads its position by {cycles} ({milliseconds})",
    "die vorgesteuerte Geschwindigkeit eilt ihrer Position um {cycles} ({milliseconds}) voraus"};
constexpr Sentence late{
    "the velocity that is fed forward lags its position by {cycles} ({milliseconds})",
    "die vorgesteuerte Geschwindigkeit eilt ihrer Position um {cycles} ({milliseconds}) nach"};
constexpr Sentence item{"`{parameter}` ({p_axis}) accounts for {cycles}",
                        "`{parameter}` ({p_axis}) macht davon {cycles} aus"};
constexpr Sentence default_item{
    "`{parameter}` ({p_axis}), which is in no list, accounts for {cycles} by default",
    "`{parameter}` ({p_axis}), das in keiner Liste steht, macht als Standardwert {cycles} aus"};
constexpr Sentence deviation{"at the acceleration limit the axis is {deviation} µm off",
                             "an der Beschleunigungsgrenze weicht die Achse um {deviation} µm ab"};
constexpr Sentence help{
    "compare with the drive's own delays; `vorsteuer.shift_time` and `vorsteuer.velocity_delay_time` set the "
    "lead",
    "mit den Verzögerungen des Antriebs vergleichen; `vorsteuer.shift_time` und "
    "`vorsteuer.velocity_delay_time` stellen den Vorlauf ein"};

}  // namespace axisc::validator::checks::ax4025::says

namespace axisc::validator::checks::ax4025 {
namespace {

void feedforward_lead(AxisContext const& context, Report& report) {
  LoadedAxis const& axis = context.machine.axes[context.index];
  EffectiveValue const& active = context.values.at("vorsteuer.default_active");
  if (!active.is_on() || !active.value_place()) return;
  auto const budget = delay_budget(axis, context.cycle_time);
  if (!budget || std::abs(budget->lead()) < noticeable_delay) return;
  double const cycles = std::abs(budget->lead());
  Finding& finding =
      report.add(active, {budget->lead() > 0 ? says::early : says::late,
                          {{"cycles", counted_cycles(cycles)},
                           {"milliseconds", milliseconds(cycles * context.cycle_time.microseconds())}}});
  for (DelayItem const& item : budget->items) {
    double const share = (item.position - item.velocity) * (budget->lead() > 0 ? 1 : -1);
    if (share == 0 || item.kind == DelayKind::lag) continue;
    finding.notes.push_back({item.cause->set() ? says::item : says::default_item,
                             {{"parameter", parameter_name(*item.cause)},
                              {"p_axis", parameter_number(*item.cause)},
                              {"cycles", counted_cycles(share)}}});
  }
  if (auto const deviation = deviation_of_lead(axis, cycles, context.cycle_time)) {
    finding.notes.push_back({says::deviation, {{"deviation", number(*deviation)}}});
  }
  finding.help.push_back({says::help, {}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .parameters =
        "vorsteuer.vorsteuerung vorsteuer.default_active vorsteuer.global_disable "
        "vorsteuer.feedforward_without_delay vorsteuer.shift_time vorsteuer.velocity_delay_time "
        "vorsteuer.timeconst_sym_filter kenngr.delay_filter_only_position kenngr.antr_typ getriebe[].kv "
        "getriebe[].dynamik.a_max",
    .needs = Needs::cycle_time,
    .check = feedforward_lead,
};

}  // namespace axisc::validator::checks::ax4025
