#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/views/axis_dynamics.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace axisc::validator::checks::ax8005::says {

constexpr Sentence headline{
    "the ramp time `{parameter}` is shorter than a cycle: it acts as a step",
    "die Rampenzeit `{parameter}` ist kürzer als ein Zyklus: sie wirkt wie ein Sprung"};
constexpr Sentence limit{"a ramp time counts from {limit} on, the cycle time",
                         "eine Rampenzeit wirkt ab {limit}, der Zykluszeit"};
constexpr Sentence too{"so is `{parameter}`", "ebenso `{parameter}`"};
constexpr Sentence help{"write at least {limit}", "mindestens {limit} schreiben"};

}  // namespace axisc::validator::checks::ax8005::says

namespace axisc::validator::checks::ax8005 {
namespace {

constexpr std::array<std::string_view, 6> ramp_times = {
    "getriebe[].slope_profil.tr_beschl_zu", "getriebe[].slope_profil.tr_beschl_ab",
    "getriebe[].slope_profil.tr_brems_zu",  "getriebe[].slope_profil.tr_brems_ab",
    "getriebe[].slope_profil.tr_grenz",     "getriebe[].dynamik.tr_geom"};

/// The control raises a ramp time below P-AXIS-00201 to it, which a finding of its own says.
void ramp_below_cycle(AxisContext const& context, Report& report) {
  double const cycle = context.cycle_time.microseconds();
  double const shortest = context.values.at("getriebe[].dynamik.tr_min").value.number;
  std::vector<EffectiveValue const*> short_ones;
  for (std::string_view const name : ramp_times) {
    EffectiveValue const& value = context.values.at(name);
    bool const is_set = value.value_place() && !value.unusable;
    if (is_set && std::max(value.value.number, shortest) < cycle) short_ones.push_back(&value);
  }
  if (short_ones.empty()) return;
  EffectiveValue const& first = *short_ones.front();
  Finding& finding = report.add(first, {says::headline, {{"parameter", parameter_name(first)}}});
  finding.label = time_in_cycles(first.value.number, context.cycle_time);
  finding.notes.push_back({says::limit, {{"limit", microseconds(cycle)}}});
  finding.help.push_back({says::help, {{"limit", microseconds(std::ceil(cycle))}}});
  for (EffectiveValue const* const other : std::span(short_ones).subspan(1)) {
    finding.related.push_back({*other->value_place(), {says::too, {{"parameter", parameter_name(*other)}}}});
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters =
        "getriebe[].slope_profil.tr_beschl_zu getriebe[].slope_profil.tr_beschl_ab "
        "getriebe[].slope_profil.tr_brems_zu getriebe[].slope_profil.tr_brems_ab "
        "getriebe[].slope_profil.tr_grenz getriebe[].dynamik.tr_geom getriebe[].dynamik.tr_min",
    .needs = Needs::cycle_time,
    .check = ramp_below_cycle,
};

}  // namespace axisc::validator::checks::ax8005
