#include "validator/engine/rule.hpp"

#include "design/filter_analysis.hpp"
#include "diagnostics/format_number.hpp"
#include "validator/rules/filter_words.hpp"

#include <cmath>
#include <string>

namespace axisc::validator::checks::ax6005::says {

constexpr Sentence headline{"the filters of this axis may amplify peaks by a factor of {gain}",
                            "die Filter dieser Achse können Spitzen auf das {gain}fache verstärken"};
constexpr Sentence headline_at_most{
    "the filters of this axis may amplify peaks by a factor of up to {gain}",
    "die Filter dieser Achse können Spitzen auf bis zu das {gain}fache verstärken"};
constexpr Sentence label{"peak gain Σ|h| = {gain}", "Spitzenverstärkung Σ|h| = {gain}"};
constexpr Sentence label_at_most{
    "peak gain Σ|h| ≤ {gain}: the filters are too slow to sum it up",
    "Spitzenverstärkung Σ|h| ≤ {gain}: die Filter sind zu langsam, um sie zu summieren"};
constexpr Sentence note{
    "peaks of velocity and acceleration may grow by this factor; every band-stop and all-pass does this",
    "Spitzen von Geschwindigkeit und Beschleunigung können um diesen Faktor wachsen; jede Bandsperre und "
    "jeder Allpass tut das"};
constexpr Sentence filter_here{"`{filter}` is part of the chain", "`{filter}` gehört zur Kette"};
constexpr Sentence help{
    "where the dynamics leave no room for it, use lower orders or a smaller share",
    "lässt die Dynamik dafür keinen Platz, kleinere Ordnungen oder einen kleineren Signalanteil verwenden"};

}  // namespace axisc::validator::checks::ax6005::says

namespace axisc::validator::checks::ax6005 {
namespace {

constexpr double noticeable = 2;
constexpr double settled = 1e-4;
constexpr double as_printed = 1e-4;

void peak_gain(AxisContext const& axis, Report& report) {
  auto const chain = axis.designs.setpoint_chain();
  if (chain.empty()) return;
  auto const figures = design::step_figures(designs(chain), design::longest_summation, settled);
  double const gain = figures.peak_gain_bound;
  if (gain <= noticeable || !std::isfinite(gain)) return;  // AX6001 reports what never settles
  bool const is_summed_up = gain <= figures.peak_gain * (1 + as_printed);
  Wording const printed = format_rounded(gain, 3);
  FilterView const& last = *chain.back().filter;
  Finding& finding =
      report.add(last.anchor(last.enable),
                 {is_summed_up ? says::headline : says::headline_at_most, {{"gain", printed}}});
  finding.label = Message{is_summed_up ? says::label : says::label_at_most, {{"gain", printed}}};
  finding.notes.push_back({says::note, {}});
  finding.help.push_back({says::help, {}});
  for (ChainLink const& link : chain) {
    FilterView const& filter = *link.filter;
    if (filter.index == last.index || !filter.enable.value_place()) continue;
    finding.related.push_back(
        {*filter.enable.value_place(), {says::filter_here, {{"filter", filter_name(filter)}}}});
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .parameters =
        "filters[].fg_f0 filters[].time_constant filters[].guete filters[].type filters[].prototype "
        "filters[].order filters[].enable filters[].share_percent",
    .needs = Needs::cycle_time,
    .check = peak_gain,
};

}  // namespace axisc::validator::checks::ax6005
