#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax4004::says {

constexpr Sentence headline{"the time delay `{filter}` comes before the active filter `{next}`",
                            "die Zeitverzögerung `{filter}` liegt vor dem aktiven Filter `{next}`"};
constexpr Sentence limit{
    "with P-AXIS-00513 = 1 only the last active filter of an axis may be a time delay",
    "mit P-AXIS-00513 = 1 darf nur der letzte aktive Filter einer Achse eine Zeitverzögerung sein"};
constexpr Sentence reaction{"it switches the time delay off", "sie schaltet die Zeitverzögerung ab"};
constexpr Sentence next_here{"`{filter}` is active after it", "`{filter}` ist danach aktiv"};
constexpr Sentence help{"make it the last one: the order of the filters does not change the result",
                        "sie zum letzten Filter machen: die Reihenfolge ändert das Ergebnis nicht"};

}  // namespace axisc::validator::checks::ax4004::says

namespace axisc::validator::checks::ax4004 {
namespace {

void delay_not_last(FilterContext const& context, Report& report) {
  FilterView const& delay = context.filter;
  EffectiveValue const& position_alone = context.axis.values.at("kenngr.delay_filter_only_position");
  if (!position_alone.is_on()) return;
  bool const is_delay = delay.standard_type == design::FilterType::time_delay;
  if (delay.port != FilterPort::setpoint || !delay.active() || !is_delay) return;
  auto const filters = context.axis.filters;
  auto const next = std::find_if(filters.begin(), filters.end(), [&](FilterView const& filter) {
    return filter.port == FilterPort::setpoint && filter.index > delay.index && filter.active();
  });
  if (next == filters.end()) return;
  Finding& finding =
      report.add(delay.anchor(delay.type),
                 {says::headline, {{"filter", filter_name(delay)}, {"next", filter_name(*next)}}});
  finding.notes.push_back({says::limit, {}});
  finding.help.push_back({says::help, {}});
  react(finding, {says::reaction, {}});
  if (next->enable.value_place()) {
    finding.related.push_back(
        {*next->enable.value_place(), {says::next_here, {{"filter", filter_name(*next)}}}});
  }
}

}  // namespace

extern constinit Rule const rule{
    .control = "110583",
    .parameters = "filters[].type filters[].enable filters[].order kenngr.delay_filter_only_position",
    .check = delay_not_last,
};

}  // namespace axisc::validator::checks::ax4004
